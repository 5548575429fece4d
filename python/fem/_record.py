"""JSON documents whose keys are attributes."""

from __future__ import annotations

import html
import json
from collections.abc import Iterator, Mapping
from typing import Any


class Record(Mapping[str, Any]):
    """An object of a JSON document: `record.key` and `record["key"]` are the same."""

    def __init__(self, keys: Mapping[str, Any]) -> None:
        self._keys: dict[str, Any] = {key: wrapped(value) for key, value in keys.items()}

    def __getitem__(self, key: str) -> Any:
        return self._keys[key]

    def __getattr__(self, name: str) -> Any:
        # Copying and unpickling ask for attributes before there are any keys.
        if name.startswith("_") or name not in self._keys:
            raise AttributeError(f"no {name!r}; there is {', '.join(self.__dict__.get('_keys', {}))}")
        return self._keys[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(key for key in self._keys if key.isidentifier())]

    def __repr__(self) -> str:
        return f"Record({', '.join(f'{key}={value!r}' for key, value in self._keys.items())})"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(key)}</th>"
            f"<td style='text-align:left'>{html.escape(repr(value))}</td></tr>"
            for key, value in self._keys.items()
        )
        return f"<table>{rows}</table>"

    def to_dict(self) -> dict[str, Any]:
        """The same as plain dictionaries and lists."""
        return {key: plain(value) for key, value in self._keys.items()}


def wrapped(value: Any) -> Any:
    """A value of a JSON document with its objects as records."""
    if isinstance(value, Mapping):
        return Record(value)
    return [wrapped(one) for one in value] if isinstance(value, list) else value


def plain(value: Any) -> Any:
    """A value with its records as dictionaries."""
    if isinstance(value, Record):
        return value.to_dict()
    return [plain(one) for one in value] if isinstance(value, list) else value


def read(text: str) -> Record:
    """A document that is an object."""
    return Record(json.loads(text))

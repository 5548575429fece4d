"""How a study grows with workers of Dask on one machine: the same jobs on more of them (strong), and as many jobs for
each (weak); what a task costs beside its jobs, and what a row costs the calling process, through which all go.

    python python/benches/scaling.py [JOBS]

Nothing else should run beside it. Needs `fem[dask]`.
"""

from __future__ import annotations

import os
import pickle
import sys
import tempfile
import time
from pathlib import Path

import fem
from fem import _fem
from distributed import Client, LocalCluster

INPUTS = {"cut.depth": {"distribution": "uniform", "half_field": "0.1 mm"}}
RESULTS = ["largest.value", "smallest.value"]
MODEL = Path(__file__).parents[2] / "models" / "lathe.toml"


def seconds(samples: int, workers: int, chunk: int) -> float:
    """Time of a study on so many workers of one thread each, s; without that of starting them."""
    with LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            client.run(lambda: __import__("fem"))
            model = fem.load(MODEL)
            start = time.perf_counter()
            model.study(INPUTS, RESULTS, design="random", samples=samples, client=client, chunk=chunk)
            return time.perf_counter() - start


def of_a_row(samples: int) -> float:
    """Time that the calling process takes for a row that a worker has sent, s."""
    with tempfile.TemporaryDirectory() as folder:
        plan, model = Path(folder, "plan.toml"), fem.load(MODEL)
        model.save(Path(folder, "model.toml"))
        plan.write_text(
            f'model = "model.toml"\ndesign = {{ type = "random", samples = {samples} }}\n'
            '[[input]]\nquantity = "cut.depth"\ndistribution = "uniform"\nhalf_field = "0.1 mm"\n'
            '[[result]]\nfigure = "largest.value"\n'
        )
        fem.study(plan, output=Path(folder, "own"))
        lines = Path(folder, "own", "rows.csv").read_text().splitlines()[1:]
        sent = [pickle.dumps(lines[first : first + 2000]) for first in range(0, samples, 2000)]
        core = _fem.Study.open(str(plan), None, str(Path(folder, "again")), False)
        start = time.perf_counter()
        for chunk in sent:
            core.append(pickle.loads(chunk))
        return (time.perf_counter() - start) / samples


def main() -> None:
    # Each worker has one core: it computes on one thread.
    os.environ["RAYON_NUM_THREADS"] = "1"
    jobs = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    print(f"{jobs} jobs, load {os.getloadavg()[0]:.1f} before")
    alone = seconds(jobs, 1, jobs // 10)
    both, weak = seconds(jobs, 2, jobs // 10), seconds(2 * jobs, 2, jobs // 10)
    print(f"one worker   {alone:7.2f} s")
    print(f"two, strong  {both:7.2f} s, {100 * alone / (2 * both):.0f} % of twice as fast")
    print(f"two, weak    {weak:7.2f} s, {100 * alone / weak:.0f} % of as fast")
    few, many = seconds(jobs, 1, jobs // 10), seconds(jobs, 1, jobs // 200)
    print(f"a row        {1e6 * of_a_row(20 * jobs):7.2f} us of the calling process")
    print(f"a task       {1e3 * (many - few) / 190:7.2f} ms beside its jobs, with reading plan and model")


if __name__ == "__main__":
    main()

"""What every peer's script does around its case: the size it is asked for, clocks, and one line of JSON.

A script does `job = Job(__doc__)` after its imports, `job.done(version, ...)` in the end.
"""

import argparse
import json
import os
import resource
import time


def cpu():
    """CPU time of this process and of those that it has waited for, s."""
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + ended.ru_utime + ended.ru_stime


class Job:
    """A case in a process of its own, from the end of its imports on."""

    def __init__(self, about):
        parser = argparse.ArgumentParser(description=about)
        parser.add_argument("size", help="elements of a shaft, or 20k, 100k, 500k unknowns")
        parser.add_argument("variant", nargs="?", default="")
        arguments = parser.parse_args()
        self.size, self.variant = arguments.size, arguments.variant
        self.threads = int(os.environ.get("OMP_NUM_THREADS", "1"))
        self.begin()

    def begin(self):
        """Sets the clocks to nothing, once all is imported."""
        self.start = time.perf_counter(), cpu()

    def done(self, version, values, **more):
        """Prints values (m or degC) and what they took, without imports."""
        wall, used = time.perf_counter() - self.start[0], cpu() - self.start[1]
        line = {"version": version, "values": [float(v) for v in values], "wall": wall, "cpu": used, **more}
        print(json.dumps(line), flush=True)

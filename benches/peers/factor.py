"""Sparse Cholesky by the library that a variant names."""


def choose(library):
    """Imports the library. Gives its name with version, and the function from a matrix to that which solves with it."""
    if library == "cholmod":
        import sksparse
        from sksparse.cholmod import analyze

        def cholmod(matrix):
            return analyze(matrix.tocsc(), mode="supernodal").cholesky(matrix.tocsc()).solve_A

        return f"scikit-sparse {sksparse.__version__}", cholmod
    if library == "pardiso":
        import importlib.metadata

        import numpy as np
        import scipy.sparse
        from pypardiso import PyPardisoSolver

        def pardiso(matrix):
            solver = PyPardisoSolver(mtype=2)
            upper = scipy.sparse.triu(matrix, format="csr")
            upper.sort_indices()

            def phase(number, right):
                # The public `solve` compares the matrix with the last one each time, and knows no triangles.
                solver.set_phase(number)
                return solver._call_pardiso(upper, right)

            phase(12, np.zeros(matrix.shape[0]))
            return lambda right: phase(33, right)

        return f"pypardiso {importlib.metadata.version('pypardiso')}", pardiso
    raise SystemExit(f"expected cholmod or pardiso, found {library!r}")

# The version of everything here: the library and its packages, the programs, the Python package.
set(GCPW_VERSION 0.1.0)

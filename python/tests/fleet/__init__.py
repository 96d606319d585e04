"""Tests of many files. They need daft, pyarrow and, for some, moto and ray: requirements.txt."""

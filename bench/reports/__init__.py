"""Markdown reports of the benchmarks, one module a program."""

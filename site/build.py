"""Builds the site of the documentation: site/build.py [--out FOLDER] [--tool GMCR].

Gathers the pages of docs/, makes the references from the source, and runs mkdocs, for which a link
that leads nowhere is an error. The pages need no network. ``pip install '.[docs]'`` brings what it
needs.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import gmcr

ROOT = Path(__file__).resolve().parents[1]
SUMMARY = ROOT / "BENCHMARK.md"  # beside docs/, but a page of the site
_CPP = """# C++ and C reference

Made from the public headers by Doxygen; the [guide](../cpp.md) says where to start.

| look it up in | what is there |
|---|---|
| [namespace `gmcr`](cpp/namespacegmcr.html) | functions: what they need, return, throw, cost |
| [classes](cpp/annotated.html) | options, results, graphs, prepared clouds and maps |
| [all members](cpp/functions.html) | every option and field by name |
| [headers](cpp/files.html) | the files of `include/` |
| [`gmcr.h`](cpp/gmcr_8h.html) | the C interface |
"""
_ARRAY = re.compile(r"(?<!\])\[(\d+|6 or 7|)\]\[([^\]]*)\]")  # "[3][3]", no link
_LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")


def gather(docs: Path, pages: Path) -> None:
    """Copies the pages; a link to a file outside of docs/ becomes the name of that file."""
    shutil.copytree(docs, pages)
    for page in pages.rglob("*.md"):
        folder = (docs / page.relative_to(pages)).parent

        def inside(link: re.Match[str], folder: Path = folder, page: Path = page) -> str:
            target = link[2].partition("#")[0]
            if not target or "://" in target:
                return link[0]
            path = (folder / target).resolve()
            if path.is_relative_to(docs) and path.is_file():
                return link[0]
            if path == SUMMARY:
                return f"[{link[1]}]({os.path.relpath(pages / SUMMARY.name, page.parent)})"
            if not path.exists():
                raise FileNotFoundError(f"{page.name}: {link[2]} leads nowhere")
            return f"`{path.relative_to(ROOT)}`" if link[1].startswith("`") else link[1]

        text = _ARRAY.sub(r"\\[\1\\]\\[\2\\]", page.read_text())
        page.write_text(_LINK.sub(inside, text))
    (pages / SUMMARY.name).write_text(SUMMARY.read_text().replace("](docs/", "]("))


def command_line(tool: Path) -> str:
    """The page of the tool: its help, command by command."""
    overview = _help(tool)
    commands = re.findall(r"^  (\w+) ", overview.partition("ommands:")[2], re.MULTILINE)
    parts = ["# Command line", "What `gmcr COMMAND --help` prints, and `man gmcr`."]
    for command in ([], *([name] for name in commands if name != "gmcr")):
        name = " ".join(["gmcr", *command])
        parts += [f"## {name}", f"```text\n{_help(tool, *command)}\n```"]
    return "\n\n".join(parts) + "\n"


def _help(tool: Path, *command: str) -> str:
    done = subprocess.run([tool, *command, "--help"], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def options() -> str:
    """The page of the options: every field, what it means, its unit, range and default."""
    parts = [
        "# Options",
        "An option has one name everywhere: `time_limit` in C++, Python and JSON, `--time-limit` "
        "on the command line. Made from the table that all of them are made from.",
    ]
    for kind in (
        gmcr.Options, gmcr.FrontendOptions, gmcr.InstanceOptions, gmcr.GravityPrior,
        gmcr.InitialPose, gmcr.CliqueOptions, gmcr.WeightedCliqueOptions, gmcr.SyntheticOptions,
    ):  # fmt: skip
        rows = ["| option | meaning | default |", "|---|---|---|"]
        for name, value in _fields(kind):
            meaning = (getattr(kind, name).__doc__ or "").replace("|", "\\|").replace("\n", " ")
            rows.append(f"| `{name}` | {meaning} | {value} |")
        parts += [f"## {kind.__name__}", "\n".join(rows)]
    return "\n\n".join(parts) + "\n"


def _fields(kind: type[Any]) -> list[tuple[str, str]]:
    """Names and defaults; what has to be given has none."""
    try:
        defaults = kind()
    except (TypeError, ValueError):
        names = [name for name, value in vars(kind).items() if isinstance(value, property)]
        return [(name, "") for name in names]
    names = [name for name in dir(kind) if isinstance(getattr(kind, name), property)]
    state = defaults.__getstate__() if hasattr(defaults, "__getstate__") else {}
    order = [name for name in state if name in names] if isinstance(state, dict) else names
    return [(name, _default(getattr(defaults, name))) for name in order or names]


def _default(value: object) -> str:
    text = "" if value is None else str(value)
    if text in ("18446744073709551615", "inf"):
        return "no limit"
    return f"`{text}`" if text and text != "[]" else ""


def python_reference(pages: Path) -> None:
    """The pages of the Python package, which mkdocstrings fills in."""
    names = "\n".join(
        f"## {name}\n\n::: gmcr.{name}\n    options:\n      heading_level: 3\n"
        for name in gmcr.__all__
        if name not in ("__version__", "CloudLike", "PointsLike", "PoseLike")
    )
    modules = "\n".join(
        f"## gmcr.{name}\n\n::: gmcr.{name}\n    options:\n      heading_level: 3\n"
        for name in ("io", "viz", "multiview", "batch")
    )
    (pages / "reference/python.md").write_text(
        f"# Python reference\n\nMade from the docstrings.\n\n{names}\n{modules}"
    )


def cpp_reference(pages: Path) -> None:
    """The reference of the public headers, by Doxygen, and the page that leads to it."""
    if not shutil.which("doxygen"):
        raise RuntimeError("the C++ reference is made by doxygen: apt-get install doxygen")
    out = pages / "reference/cpp"
    out.mkdir()
    given = {
        "OUT": out, "VERSION": gmcr.__version__, "INCLUDE": ROOT / "include",
        "START": ROOT / "site/cpp_start.md",
    }  # fmt: skip
    done = subprocess.run(
        ["doxygen", ROOT / "site/Doxyfile"],
        capture_output=True,
        text=True,
        env=os.environ | {name: str(value) for name, value in given.items()},
    )
    if done.returncode:
        raise RuntimeError(done.stdout + done.stderr)
    (pages / "reference/cpp.md").write_text(_CPP)


def build(out: Path, tool: Path) -> Path:
    """Builds the site.

    Returns
    -------
    Path
        Its folder of HTML.
    """
    shutil.rmtree(out, ignore_errors=True)
    pages = out / "pages"
    out.mkdir(parents=True)
    gather(ROOT / "docs", pages)
    (pages / "reference").mkdir()
    (pages / "reference/cli.md").write_text(command_line(tool))
    (pages / "reference/options.md").write_text(options())
    cpp_reference(pages)
    python_reference(pages)
    (out / "package").symlink_to(Path(gmcr.__file__).parents[1])
    shutil.copy(ROOT / "site/mkdocs.yml", out)
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict"],
        cwd=out, capture_output=True, text=True,
    )  # fmt: skip
    if done.returncode:
        raise RuntimeError(done.stdout + done.stderr)
    return out / "html"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "build/site")
    parser.add_argument("--tool", type=Path, default=ROOT / "build/release/bin/gmcr")
    given = parser.parse_args()
    print(build(given.out.resolve(), given.tool.resolve()) / "index.html")


if __name__ == "__main__":
    main()

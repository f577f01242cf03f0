"""What a program of ours links and how it is hardened: ``linked_test.py PROGRAM [LINK_MAP]``.

Reads the ELF file and, of the tool, the linker's map. Exits with 1 and says what is wrong.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# library, by its file without version: its name in THIRD_PARTY.md. No other may be linked.
KNOWN = {
    "libfmt": "{fmt}",
    "libhwy": "Highway",
    "liblzf": "liblzf",
    "libspdlog": "spdlog",
    "libtbb": "oneTBB",
}
# of the system: the GPL of libgcc and libstdc++ excepts programs that are compiled with GCC
SYSTEM = {
    "ld-linux", "libc", "libc_nonshared", "libdl", "libgcc", "libgcc_s", "libm", "libmvec",
    "libpthread", "librt", "libstdc++", "libssp_nonshared",
}  # fmt: skip


def library_of(path: str) -> str:
    """Its name; auditwheel puts a hash into that of a library which a wheel brings."""
    return re.sub(r"(-x86-64|-aarch64|-[0-9a-f]{8})?\.(so|a)(\.[0-9.]+)?$", "", Path(path).name)


def readelf(*arguments: str | Path) -> str:
    done = subprocess.run(
        ["readelf", "--wide", *arguments], capture_output=True, text=True, check=True
    )
    return done.stdout


def problems_of_libraries(paths: list[str]) -> list[str]:
    page = (ROOT / "THIRD_PARTY.md").read_text()
    found = []
    for library in sorted({library_of(path) for path in paths} - SYSTEM):
        if library not in KNOWN:
            found.append(f"links {library}, which THIRD_PARTY.md does not know")
            continue
        name = KNOWN[library]
        row = next((line for line in page.splitlines() if line.startswith(f"| {name} ")), "")
        if "linked" not in row:
            found.append(f"links {library}, which THIRD_PARTY.md does not say of {name}")
        if "GPL" in row:
            found.append(f"links {library}, whose licence is {row.split('|')[-2].strip()}")
    return found


def loaded_by_the_linker(link_map: str) -> list[str]:
    """All archives and shared libraries outside the build, whether they are needed or not."""
    paths = re.findall(r"^LOAD (/\S+\.(?:a|so)\S*)$", link_map, re.M)
    return [path for path in paths if not Path(path).is_relative_to(ROOT)]


def problems_of_hardening(program: Path) -> list[str]:
    header, segments, dynamic = (readelf(flag, program) for flag in ("-h", "-l", "-d"))
    stack = re.search(r"GNU_STACK.*", segments)
    symbols = readelf("--symbols", "--use-dynamic", program) + readelf("--dyn-syms", program)
    search_paths = re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", dynamic)
    flags = " ".join(re.findall(r"\(FLAGS(?:_1)?\)\s*(.*)", dynamic))
    wanted = {
        "position-independent": "DYN" in header,
        "a stack that is not executable": stack is not None and "RWE" not in stack[0],
        "relocations that become read-only": "GNU_RELRO" in segments,
        "all symbols bound at the start": "NOW" in flags,
        "a protected stack": "__stack_chk_fail" in symbols,
        "fortified functions": re.search(r"__\w+_chk\b", symbols.replace("__stack_chk", ""))
        is not None,
        "no writable code": not re.search(r"LOAD.* RWE ", segments),
        "no search path but beside itself": all(
            path.startswith("$ORIGIN") for path in search_paths
        ),
    }
    return [f"lacks {what}" for what, holds in wanted.items() if not holds]


def exported(program: Path) -> list[str]:
    """Functions and data that others can bind to."""
    rows = (line.split() for line in readelf("--dyn-syms", program).splitlines())
    return [
        row[7].split("@")[0]
        for row in rows
        if len(row) >= 8 and row[3] in ("FUNC", "OBJECT") and row[4] == "GLOBAL" and row[6] != "UND"
    ]


def main(program: Path, link_map: Path | None) -> int:
    needed = re.findall(r"\(NEEDED\).*\[(.+)\]", readelf("-d", program))
    found = problems_of_libraries(needed) + problems_of_hardening(program)
    if link_map is not None:
        text = link_map.read_text()
        if "LOAD " not in text:
            found.append(f"{link_map} is no map of a linker")
        found += problems_of_libraries(loaded_by_the_linker(text))
    if program.suffix == ".so":
        strangers = [name for name in exported(program) if not name.startswith("PyInit_")]
        if strangers:
            found.append(f"exports {len(strangers)} symbols, such as {strangers[0]}")
    for problem in found:
        print(f"{program.name}: {problem}")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else None))

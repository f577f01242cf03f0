"""The pages are true: what code cites is defined, what pages name is there, links lead somewhere.

Each check returns its faults as sentences; the tests below plant one fault of each kind as well.
"""

import re
import tempfile
import unittest
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CODE = ("include", "src", "apps", "bench", "python", "examples", "tests", "cmake", "tools")
CODE_SUFFIXES = {".hpp", ".cpp", ".c", ".h", ".py", ".pyi", ".txt", ".cmake", ".in", ".json", ""}
BUILD_FILES = {"CMakeLists.txt", "CMakePresets.json", "Makefile", "pyproject.toml"}
GENERATED = {"build", "out", "__pycache__"}
METHOD, ARCHITECTURE, DECISIONS = "docs/method.md", "docs/architecture.md", "docs/decisions"
PAGES_OF_NAMES = (METHOD, ARCHITECTURE, "CONTRIBUTING.md")
RECORDS = "docs/benchmarks"
VERSIONS = {
    "CITATION.cff": r"^version: (\S+)$",
    "packaging/conan/conanfile.py": r'^ *version = "([^"]+)"$',
    "packaging/vcpkg/*/vcpkg.json": r'^ *"version": "([^"]+)",?$',
    "packaging/ros/*/package.xml": r"<version>([^<]+)</version>",
}
TEMPLATES = "bench/reports/pages"
PARTS_OF = {"bench/paper/discussion.md": f"{RECORDS}/paper.md"}


def is_kept(root: Path, path: Path) -> bool:
    """Whether a path is part of the repository, as far as its name tells."""
    parts = path.relative_to(root).parts
    return not any(part in GENERATED or (part[0] == "." and part != ".ci") for part in parts)


@cache
def code(root: Path) -> dict[str, str]:
    """The files of code and their text, but for this one, which plants faults."""
    files: dict[str, str] = {}
    for folder in CODE:
        for path in sorted((root / folder).rglob("*")):
            if not (path.is_file() and path.suffix in CODE_SUFFIXES and is_kept(root, path)):
                continue
            if path.name != Path(__file__).name:
                files[str(path.relative_to(root))] = path.read_text(errors="replace")
    return files


@cache
def pages(root: Path) -> dict[str, str]:
    """The Markdown files and their text."""
    paths = sorted(path for path in root.rglob("*.md") if is_kept(root, path))
    return {str(path.relative_to(root)): path.read_text() for path in paths}


def without_blocks(page: str) -> str:
    """A page without its fenced blocks of code."""
    return re.sub(r"^```.*?^```", "", page, flags=re.DOTALL | re.MULTILINE)


def comments(name: str, text: str) -> str:
    """What a file says in comments, a comment of several lines as one; all of a Python file."""
    if name.endswith((".py", ".pyi")):
        return re.sub(r"\s*\n\s*#? ?", " ", text)
    mark = "#" if name.endswith((".txt", ".cmake")) else "//"
    lines = [line.partition(mark) for line in text.splitlines()]
    return "".join(f" {rest.lstrip('/!<').strip()}" if found else "\n" for _, found, rest in lines)


def statements(root: Path) -> set[str]:
    """The statements that the page of the method proves."""
    return set(re.findall(r"^### (L\d+)\. ", pages(root).get(METHOD, ""), re.MULTILINE))


def equations(root: Path) -> dict[int, str]:
    """The numbers and labels in the page's table of equations."""
    rows = re.findall(r"^\| \((\d+)\) \| (\S+) \|", pages(root).get(METHOD, ""), re.MULTILINE)
    return {int(number): label for number, label in rows}


def faults_of_citations(root: Path) -> Iterator[str]:
    """Statements and equations that are cited and not defined, or not by their number."""
    known, numbered = statements(root), equations(root)
    for name, text in code(root).items():
        said = comments(name, text)
        for statement in sorted(set(re.findall(r"\bL\d+\b(?! cache)", said)) - known):
            yield f"{name} cites {statement}, which {METHOD} does not prove"
        for cited in re.finditer(r"\b(?:[Ee]quations?|Eqs?\.?) ?\(?\d[^.;]*", said):
            numbers = re.match(r"Eq\. ((?:\(\d+\)(?:, (?=\()| and | to )?)+)", cited[0])
            if not numbers:
                yield f"{name} cites '{cited[0][:20]}': write Eq. (n)"
                continue
            for number in map(int, re.findall(r"\d+", numbers[1])):
                if number not in numbered:
                    yield f"{name} cites Eq. ({number}), which {METHOD} does not have"
        for label in re.finditer(r"\beq:[a-z_0-9]+(?::[a-z_0-9]+)*", said):
            before = re.search(r"Eq\. \((\d+)\),? \(?$", said[: label.start()])
            if not before or numbered.get(int(before[1])) != label[0]:
                yield f"{name} cites {label[0]} without its number"
    for name, text in pages(root).items():
        if name != METHOD and re.search(r"\beq:[a-z_]+", text):
            yield f"{name} cites an equation by its label"


def tests_of(root: Path) -> set[str]:
    """Names of the tests, Suite.Name."""
    pattern = re.compile(r"^(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+)", re.MULTILINE)
    texts = (text for name, text in code(root).items() if name.startswith("tests/"))
    return {f"{suite}.{case}" for text in texts for suite, case in pattern.findall(text)}


@cache
def words(root: Path) -> set[str]:
    """All identifiers of the code and of what builds it."""
    texts = [path.read_text() for path in root.glob("*") if path.name in BUILD_FILES]
    return {word for text in (*code(root).values(), *texts) for word in re.findall(r"\w+", text)}


def is_path(span: str) -> bool:
    """Whether a piece of code on a page means a file or folder of the repository."""
    if not re.fullmatch(r"[\w.*/-]+", span) or span.split("/")[0] in GENERATED:
        return False
    return "/" in span.strip("/") or span.endswith((".hpp", ".cpp", ".py", ".md", ".txt", "/"))


def faults_of_names(root: Path) -> Iterator[str]:
    """Files, functions and tests that a page names and that are not there."""
    tests = tests_of(root)
    makefile = root / "Makefile"
    targets = makefile.read_text() if makefile.exists() else ""
    for name in PAGES_OF_NAMES:
        page = without_blocks(pages(root).get(name, ""))
        if not page:
            yield f"{name} is missing"
        for place in re.finditer(r"`([\w./-]+)`:\s((?:`[\w:]+`(?:,\s|\sand\s)?)+)", page):
            text = code(root).get(place[1], "")
            for function in re.findall(r"`(?:\w+::)*(\w+)`", place[2]):
                if not re.search(rf"\b{function}\b", text):
                    yield f"{name}: {place[1]} has no {function}"
        for span in re.findall(r"`([^`\n]+)`", page):
            if is_path(span):
                if not any(root.glob(span.strip("/"))):
                    yield f"{name} names {span}, which is not there"
            elif re.fullmatch(r"[A-Z]\w*\.[A-Z]\w+", span):
                if span not in tests:
                    yield f"{name} names the test {span}, which is not there"
            elif made := re.fullmatch(r"make ([\w-]+)", span):
                if not re.search(rf"^{made[1]}:", targets, re.MULTILINE):
                    yield f"{name} names {span}, which the Makefile does not have"
            elif re.fullmatch(r"[A-Za-z_][\w:]{2,}(\(\))?", span):
                if span.rstrip("()").split("::")[-1] not in words(root):
                    yield f"{name} names {span}, which the code does not have"


def anchors(page: str) -> set[str]:
    """What a link can name within a page: its headings, as GitHub turns them into names."""
    found: list[str] = []
    for heading in re.findall(r"^#+ (.+)$", without_blocks(page), re.MULTILINE):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading.strip().lower())
        found.append(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return {f"{a}-{n}" if (n := found[:k].count(a)) else a for k, a in enumerate(found)}


def faults_of_links(root: Path) -> Iterator[str]:
    """Relative links that lead nowhere, and pages that are mentioned and not there."""
    for name, page in pages(root).items():
        links = re.findall(r"\]\(([^)\s]+)[^)]*\)|<img[^>]* src=\"([^\"]+)\"", without_blocks(page))
        for link in (first or second for first, second in links):
            if re.match(r"[a-z]+:", link):
                continue
            file, _, anchor = link.partition("#")
            page_of_link = root / PARTS_OF.get(name, name.replace(TEMPLATES, RECORDS))
            target = page_of_link.parent / file if file else page_of_link
            if not target.exists():
                yield f"{name} links to {link}, which is not there"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text()):
                yield f"{name} links to {link}, which is no heading"
    for name, text in {**code(root), **pages(root)}.items():
        for mention in re.findall(r"(?<![\w./*-])((?:docs|bench)/[\w./-]+\.md|[A-Z]+\.md)\b", text):
            if not any(page == mention or page.endswith(f"/{mention}") for page in pages(root)):
                yield f"{name} mentions {mention}, which is not there"
        if re.search(r"\bDESIGN\b", text):
            yield f"{name} mentions DESIGN, a page that is not there"


def faults_of_decisions(root: Path) -> Iterator[str]:
    """Decision records that the index lacks, names otherwise, or numbers with a gap."""
    index = pages(root).get(f"{DECISIONS}/README.md", "")
    entries = dict(re.findall(r"^\| \[\d+\]\(([^)]+)\) \| (.+?) \|", index, re.MULTILINE))
    records = [name for name in pages(root) if re.match(rf"{DECISIONS}/\d", name)]
    for number, name in enumerate(records, 1):
        heading, file = pages(root)[name].splitlines()[0], Path(name).name
        if not file.startswith(f"{number:04}-") or not heading.startswith(f"# {number}. "):
            yield f"{name} is not number {number}"
        elif file not in entries:
            yield f"{name} is not in the index"
        elif entries[file] != heading.removeprefix(f"# {number}. "):
            yield f"the index calls {name} '{entries[file]}'"


def faults_of_layers(root: Path) -> Iterator[str]:
    """Folders that the page of the architecture allows other folders than the test of includes."""
    rules = code(root).get("tests/architecture/check_places.cmake", "")
    rows = re.findall(r"^only_from\((\w+) ([^)]*)\)", rules, re.MULTILINE)
    allowed = {folder: {*names.split()} - {"-"} for folder, names in rows}
    page = pages(root).get(ARCHITECTURE, "")
    rows = re.findall(r"^\| \[(\w+)\]\(\.\./src/\w+\) \|[^|]*\| ([\w, ]*) ?\|$", page, re.MULTILINE)
    drawn = {folder: {*re.findall(r"\w+", names)} - {"nothing"} for folder, names in rows}
    for folder in sorted(allowed.keys() | drawn.keys()):
        if allowed.get(folder) != drawn.get(folder):
            yield f"{ARCHITECTURE} and the test of includes differ on what {folder} uses"
    for folder in sorted(path.name for path in (root / "src").glob("*/")):
        if folder not in drawn:
            yield f"{ARCHITECTURE} has no row for src/{folder}"


def faults_of_versions(root: Path) -> Iterator[str]:
    """Files that state another version than the build."""
    build = root / "CMakeLists.txt"
    found = (
        re.search(r"^project\(gmcr VERSION ([\d.]+)", build.read_text(), re.MULTILINE)
        if build.exists()
        else None
    )
    if not found:
        return
    stated = [
        (path, re.findall(pattern, path.read_text(), re.MULTILINE))
        for glob, pattern in VERSIONS.items()
        for path in sorted(root.glob(glob))
    ]
    for path, versions in stated:
        if versions[:1] != [found[1]]:
            yield f"{path.relative_to(root)} is not of version {found[1]}"


CHECKS = (
    faults_of_citations,
    faults_of_names,
    faults_of_links,
    faults_of_decisions,
    faults_of_layers,
    faults_of_versions,
)

CLEAN = {
    "CMakeLists.txt": "project(gmcr VERSION 1.0.0)\n",
    "CITATION.cff": "title: gmcr\nversion: 1.0.0\n",
    "CONTRIBUTING.md": "Run `make test`, see `src/a.cpp` and [A](docs/architecture.md#a-part).\n",
    "Makefile": "test: build\n",
    METHOD: "### L1. One\n`src/a.cpp`: `f`. `A.Works`\n| (1) | eq:one | a |\n| (2) | none | b |\n",
    ARCHITECTURE: "# A part\n```sh\n[no](link.md) `nothing`\n```\n`src/`, `name::f()`\n\n"
    "| [b](../src/b) | all | c, d |\n| [c](../src/c) | some | nothing |\n",
    f"{DECISIONS}/README.md": "| [1](0001-a.md) | First |\n",
    f"{DECISIONS}/0001-a.md": "# 1. First\n",
    "src/b/b.cpp": "",
    "src/c/c.cpp": "",
    "tests/architecture/check_places.cmake": "only_from(b d c)\nonly_from(c -)\n",
    "src/a.cpp": "// L1, Eq. (1), eq:one, and Eq.\n// (1) and (2): from the L2 cache\nint f();\n",
    "tests/a_test.cpp": "TEST(A, Works) {}\n",
}


class Pages(unittest.TestCase):
    def test_are_true(self) -> None:
        for check in CHECKS:
            with self.subTest(check.__name__):
                self.assertEqual(list(check(ROOT)), [])

    def faults_of(self, changes: dict[str, str]) -> list[str]:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            for name, text in {**CLEAN, **changes}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return [fault for check in CHECKS for fault in check(root)]

    def test_that_are_true_have_no_faults(self) -> None:
        self.assertEqual(self.faults_of({}), [])

    def test_each_kind_of_fault_is_found(self) -> None:
        method, index = CLEAN[METHOD], CLEAN[f"{DECISIONS}/README.md"]
        planted = [
            ("src/a.cpp", "// L3: f\n", "cites L3"),
            ("src/a.cpp", "int f();  // Eq. (3)\n", "cites Eq. (3)"),
            ("src/a.cpp", "// f, Eq.\n/// (1) and\n/// (3)\n", "cites Eq. (3)"),
            ("src/a.cpp", "// f, Equation 1\n", "write Eq. (n)"),
            ("src/a.cpp", "// f, eq:one\n", "cites eq:one without its number"),
            ("src/a.cpp", "// f, Eq. (2), eq:one\n", "cites eq:one without its number"),
            ("python/a.py", '"""f\n\nL4."""\n', "cites L4"),
            ("src/a.cpp", "int g();\n", "src/a.cpp has no f"),
            ("tests/a_test.cpp", "TEST(A, Fails) {}\n", "names the test A.Works"),
            (METHOD, method + "`src/b.cpp`", "names src/b.cpp"),
            (METHOD, method + "`nowhere_defined`", "names nowhere_defined"),
            (METHOD, method + "`make tea`", "names make tea"),
            (METHOD, method + "[b](b.md)", "links to b.md"),
            (METHOD, method + "![b](b.png)", "links to b.png"),
            (METHOD, method + "[A](architecture.md#a-whole)", "is no heading"),
            ("README.md", "as eq:one\n", "cites an equation by its label"),
            ("src/b.cpp", "// see PLAN.md\n", "mentions PLAN.md"),
            ("src/b.cpp", "// see DESIGN\n", "mentions DESIGN"),
            ("src/d/d.cpp", "", "has no row for src/d"),
            (
                "tests/architecture/check_places.cmake",
                "only_from(b c)\nonly_from(c -)\n",
                "differ on what b uses",
            ),
            ("CITATION.cff", "version: 2.0.0\n", "CITATION.cff is not of version 1.0.0"),
            (f"{DECISIONS}/0002-b.md", "# 2. Second\n", "0002-b.md is not in the index"),
            (f"{DECISIONS}/0003-b.md", "# 3. Third\n", "is not number 2"),
            (f"{DECISIONS}/README.md", index.replace("First", "Other"), "the index calls"),
        ]
        for name, text, fault in planted:
            with self.subTest(fault):
                found = self.faults_of({name: text})
                self.assertTrue(any(fault in sentence for sentence in found), found)


if __name__ == "__main__":
    unittest.main()

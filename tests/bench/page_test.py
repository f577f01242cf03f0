"""The pages of the benchmarks: what fills them, what stays, and what the summary says of them."""

import re
import sys
import tempfile
import unittest
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

import summary  # noqa: E402
from page_block import replace_block  # noqa: E402
from reports.page import LONGEST, PLACE, TEMPLATES, compose, fold_tables, missing  # noqa: E402

NUMBER = r"\d[\d,]*(?:\.\d+)?(?<!,)"
REPORT = "# Speed\n\nFirst.\n\n## Small\n\n| # |\n\n## Large\n\nLast.\n"


class Page(unittest.TestCase):
    def test_reports_fill_their_places_a_level_down(self) -> None:
        page = compose("# Page\n\n{{speed}}\n\nEnd.", {"speed": REPORT}, "")
        self.assertEqual(
            page,
            "# Page\n\n## Speed\n\nFirst.\n\n### Small\n\n| # |\n\n### Large\n\nLast.\n\nEnd.\n",
        )

    def test_prose_can_stand_between_two_sections_of_a_report(self) -> None:
        template = "{{speed until Large}}\n\nBetween.\n\n{{speed from Large}}"
        page = compose(template, {"speed": REPORT}, "")
        self.assertEqual(
            page.replace("Between.\n\n", ""), compose("{{speed}}", {"speed": REPORT}, "")
        )
        self.assertLess(page.index("### Small"), page.index("Between."))
        self.assertLess(page.index("Between."), page.index("### Large"))

    def test_what_another_program_wrote_between_markers_is_kept(self) -> None:
        empty = "<!-- begin more -->\n<!-- end more -->"
        filled = "<!-- begin more -->\n## More\n\n{{speed}} \\1\n<!-- end more -->"
        page = compose(f"A\n\n{empty}\n\nB", {}, f"old A\n\n{filled}\n\nold B")
        self.assertEqual(page, f"A\n\n{filled}\n\nB\n")
        self.assertEqual(compose(f"A\n\n{empty}", {}, ""), f"A\n\n{empty}\n")

    def test_long_tables_are_folded_once(self) -> None:
        head = "| N | ms |\n| --- | --- |\n"
        short = head + "| 1 | 2 |\n" * LONGEST
        long = short + "| 1 | 2 |\n"
        self.assertEqual(fold_tables(short), short)
        folded = fold_tables(f"A\n\n{long}\nB\n")
        self.assertIn(f"<summary>{LONGEST + 1} rows: N, ms</summary>\n\n{long}\n</details>", folded)
        self.assertEqual(fold_tables(folded), folded)

    def test_nothing_is_left_out_silently(self) -> None:
        for template, before in [
            ("{{other}}", ""),
            ("{{speed from Nowhere}}", ""),
            ("A", "<!-- begin more -->\n<!-- end more -->"),
        ]:
            with self.assertRaises(ValueError):
                compose(template, {"speed": REPORT}, before)

    def test_what_a_template_asks_for_is_known(self) -> None:
        self.assertEqual(missing("{{a}}\n\n{{b until C}}\n\n{{d}}", {"a": ""}), ["b", "d"])

    def test_the_pages_of_the_project_are_their_templates_filled_in(self) -> None:
        templates = sorted(TEMPLATES.glob("*.md"))
        self.assertGreater(len(templates), 8)
        for template in templates:
            page = (ROOT / "docs/benchmarks" / template.name).read_text()
            prose = re.sub(
                r"<!-- begin .*<!-- end \S+ -->",
                "",
                PLACE.sub("", template.read_text()),
                flags=re.DOTALL,
            )
            for paragraph in filter(None, map(str.strip, prose.split("\n\n"))):
                self.assertIn(paragraph, page)

    def test_a_block_is_written_where_it_stands(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            pages = Path(folder) / "benchmarks"
            pages.mkdir()
            (pages / "a.md").write_text("A\n\n<!-- begin more -->\nold\n<!-- end more -->\n\nB\n")
            (pages / "b.md").write_text("<!-- begin other -->\n<!-- end other -->\n")
            replace_block(Path(folder), "more", "new \\1\n")
            text = "A\n\n<!-- begin more -->\nnew \\1\n<!-- end more -->\n\nB\n"
            self.assertEqual((pages / "a.md").read_text(), text)
            with self.assertRaisesRegex(SystemExit, "0 blocks of none"):
                replace_block(Path(folder), "none", "new")
            (pages / "b.md").write_text(text)
            with self.assertRaisesRegex(SystemExit, "2 blocks of more"):
                replace_block(Path(folder), "more", "new")
            replace_block(pages / "b.md", "more", "newer")
            self.assertIn("newer", (pages / "b.md").read_text())

    def test_every_block_that_a_program_writes_has_a_place(self) -> None:
        pages = "".join(page.read_text() for page in (ROOT / "docs/benchmarks").glob("*.md"))
        programs = [path.read_text() for path in (ROOT / "bench").glob("*.py")]
        names = re.findall(r'replace_block\(\w+\.docs, "(\w+)"', "".join(programs))
        self.assertGreaterEqual(len(names), 6)
        for name in names:
            self.assertEqual(pages.count(f"<!-- begin {name} -->"), 1, name)


class Summary(unittest.TestCase):
    def test_the_page_of_one_screen_says_what_the_records_say(self) -> None:
        records = summary.Records.read()
        self.assertEqual(summary.PAGE.read_text(), summary.compose(records), "run bench/summary.py")

    def test_figures_are_looked_up_by_heading_row_and_column(self) -> None:
        table = "| N | a | b | a |\n| --- | --- | --- | --- |\n| 1 | 2.5 (2-3) | > 5 | 9 |\n"
        page = f"## Speed\n\n{table}"
        row = summary.Records(page).row("Speed", "b", N="1")
        self.assertEqual(summary.number(row["a"]), 2.5)
        self.assertEqual(summary.ratio(row["b"], row["a"]), "> 2.0 x")
        for key in ({"N": "2"}, {"M": "1"}):
            with self.assertRaises(KeyError):
                summary.Records(page).row("Speed", "b", **key)

    def test_runs_of_all_pages_are_counted_together(self) -> None:
        said = "The truth lies above a proven upper bound in {} of {} runs.\n"
        records = summary.Records(said.format(1, 20) + "\n## A\n\n" + said.format(2, 30))
        self.assertIn("in 3 of 50 runs", records.bounds())

    def test_figures_of_the_overview_stand_in_the_tables_that_it_links(self) -> None:
        overview = (ROOT / "docs/benchmarks.md").read_text()
        self.assertEqual(list(unfounded(overview, ROOT / "docs")), [])
        wrong = overview.replace("0 of 9360 runs", "0 of 9361 runs")
        self.assertEqual(list(unfounded(wrong, ROOT / "docs")), ["Proofs: 9361"])


def unfounded(overview: str, docs: Path) -> Iterator[str]:
    """Figures of a section that none of the pages has that it links."""
    for section in re.split(r"^## ", overview, flags=re.MULTILINE)[1:]:
        if section.startswith("The recorded run"):
            continue
        links = re.findall(r"\]\((benchmarks/\w+\.md)", section)
        known = set(re.findall(NUMBER, "".join((docs / link).read_text() for link in links)))
        code = r"```.*?```|`[^`]*`|\[decision[^]]*\]|\]\([^)]*\)"
        said = re.sub(code, "", section, flags=re.DOTALL)
        for figure in re.findall(NUMBER, said):
            if figure not in known:
                yield f"{section.splitlines()[0]}: {figure}"


if __name__ == "__main__":
    unittest.main()

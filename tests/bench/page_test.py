"""The page of the benchmarks: what fills its template, and what stays."""

import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))

import summary  # noqa: E402
from reports.page import LONGEST, PLACE, TEMPLATE, compose, fold_tables  # noqa: E402

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

    def test_the_page_of_the_project_is_its_template_filled_in(self) -> None:
        page = (ROOT / "docs" / "benchmarks.md").read_text()
        prose = re.sub(
            r"<!-- begin .*<!-- end \S+ -->",
            "",
            PLACE.sub("", TEMPLATE.read_text()),
            flags=re.DOTALL,
        )
        for paragraph in filter(None, map(str.strip, prose.split("\n\n"))):
            self.assertIn(paragraph, page)


class Summary(unittest.TestCase):
    def test_the_page_of_one_screen_says_what_the_records_say(self) -> None:
        records = summary.Records(summary.RECORDS.read_text())
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


if __name__ == "__main__":
    unittest.main()

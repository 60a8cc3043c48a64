"""The documentation as a site: navigation, links, diagrams, search, and nothing that whoever reads it would have to fetch."""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path
from urllib.parse import unquote

from test_commands import LIMIT_S, ROOT

_REFERENCE = re.compile(r'(?:href|src)="([^"]*)"')
_ID = re.compile(r'\bid="([^"]*)"')
_FETCHED = re.compile(r'(?:<script[^>]* src|<link rel="stylesheet" href|<img[^>]* src)="http')


class SiteTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory(prefix="evoloop-site-")
        cls.addClassCleanup(folder.cleanup)
        cls.site = Path(folder.name) / "site"
        result = subprocess.run(
            [ROOT / "docs/site/build", cls.site], capture_output=True, encoding="utf-8", timeout=LIMIT_S, stdin=subprocess.DEVNULL
        )
        if result.returncode != 0:
            raise AssertionError(result.stderr)
        cls.pages = {
            page.relative_to(cls.site).as_posix(): page.read_text(encoding="utf-8")
            for page in cls.site.glob("**/*.html")
            if page.name != "404.html" and page.parent.name != "api"
        }

    def test_every_page_is_there_and_shows_where_it_is(self) -> None:
        written = {
            file.relative_to(ROOT).with_name("index.html" if file.name == "README.md" else f"{file.stem}.html").as_posix()
            for file in (*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("docs/adr/*.md"), *ROOT.glob("models/*.md"))
        }
        self.assertLessEqual(written | {"prism/results/report.html", "benchmarks/index.html"}, self.pages.keys())
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.assertIn("md-nav__link--active", page)
                self.assertIn("md-tabs__item--active", page)
                self.assertEqual(name == "index.html", "md-path__list" not in page)

    def test_every_link_leads_to_a_file_of_the_site_and_to_an_anchor_in_it(self) -> None:
        links = 0
        for name, page in self.pages.items():
            for link in _REFERENCE.findall(page):
                if re.match(r"[a-z]+:", link):
                    continue
                links += 1
                path, _, anchor = unquote(link).partition("#")
                file = (self.site / name).parent / path if path else self.site / name
                with self.subTest(page=name, link=link):
                    file = file / "index.html" if file.is_dir() else file
                    self.assertTrue(file.is_file())
                    if anchor and file.suffix == ".html":
                        self.assertIn(anchor, _ID.findall(file.read_text(encoding="utf-8")))
        self.assertGreater(links, 2_000)

    def test_diagrams_are_drawn_by_a_script_of_the_site(self) -> None:
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.assertEqual('<pre class="mermaid">' in page, "mermaid.min.js" in page)
        self.assertEqual(self.pages["index.html"].count('<pre class="mermaid">'), 2)
        self.assertIn("stateDiagram", (self.site / "mermaid.min.js").read_text(encoding="utf-8"))

    def test_it_can_be_searched_without_a_server(self) -> None:
        self.assertIn("How Evoloop works", (self.site / "search" / "search_index.js").read_text(encoding="utf-8"))
        self.assertIn('data-md-component="search"', self.pages["index.html"])
        self.assertIn("IFrameWorker", (self.site / "iframe-worker.js").read_text(encoding="utf-8"))

    def test_it_is_light_or_dark_and_fetches_nothing(self) -> None:
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.assertIn('data-md-color-scheme="slate"', page)
                self.assertNotRegex(page, _FETCHED)

    def test_a_link_that_leads_nowhere_is_refused_by_name(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "pages").mkdir()
            Path(folder, "pages", "README.md").write_text("# A page\n\n[nowhere](docs/gone.md#x) [neither](#gone)\n", encoding="utf-8")
            result = subprocess.run(
                [ROOT / "target/site-venv/bin/mkdocs", "build", "-f", ROOT / "docs/site/mkdocs.yml", "-d", Path(folder, "site")],
                env={**os.environ, "EVOLOOP_PAGES": str(Path(folder, "pages"))},
                capture_output=True,
                encoding="utf-8",
                timeout=LIMIT_S,
            )
        self.assertEqual(result.returncode, 1)
        self.assertIn("'README.md' contains a link 'docs/gone.md#x', but the target 'docs/gone.md' is not found", result.stderr)
        self.assertIn("'README.md' contains a link '#gone', but there is no such anchor on this page", result.stderr)


if __name__ == "__main__":
    unittest.main()

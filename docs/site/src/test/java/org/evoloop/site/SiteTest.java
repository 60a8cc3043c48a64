package org.evoloop.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The documentation of this project, as a site. */
class SiteTest {
    private static final Path ROOT = Path.of(System.getProperty("evoloop.root"));
    private static final Pattern REFERENCE = Pattern.compile("(?:href|src)=\"([^\"]*)\"");
    private static final Pattern ID = Pattern.compile(" id=\"([^\"]*)\"");

    @TempDir
    private Path out;

    @Test
    void everyLinkLeadsToAFileOfTheSiteAndToAnAnchorInIt() throws IOException {
        new Site(ROOT, out).write();

        List<String> broken = new ArrayList<>();
        int links = 0;
        for (Path page : pages()) {
            for (String link : found(REFERENCE, page)) {
                links++;
                if (!link.matches("https?:.*") && !link.endsWith(Site.API) && !leadsSomewhere(page, link)) {
                    broken.add(out.relativize(page) + ": " + link);
                }
            }
        }
        assertThat(broken).isEmpty();
        assertThat(links).isGreaterThan(200);
    }

    @Test
    void everyPageOfTheDocumentationIsThereAndFetchesNothing() throws IOException {
        new Site(ROOT, out).write();

        assertThat(out.resolve("index.html")).content().contains("<title>Evoloop</title>", "docs/index.html");
        assertThat(out.resolve("docs/design.html")).content().contains("<h1 id=\"how-evoloop-works\">", "<table>");
        assertThat(out.resolve("docs/mechanism.svg")).hasSameBinaryContentAs(ROOT.resolve("docs/mechanism.svg"));
        for (Path page : pages()) {
            assertThat(page).content().doesNotContain("<script", "src=\"http", "stylesheet\" href=\"http");
        }
    }

    @Test
    void aLinkThatLeadsNowhereIsRefusedByName() throws IOException {
        Path root = Files.createDirectories(out.resolve("root"));
        for (String page : List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")) {
            Files.writeString(root.resolve(page), "# A page\n\n[nowhere](docs/gone.md#x)\n");
        }
        Files.createDirectories(root.resolve("docs"));

        assertThatThrownBy(() -> new Site(root, out.resolve("site")).write())
                .isInstanceOf(NoSuchFileException.class)
                .hasMessage("docs/gone.md: there is no such file, but a link in README.md");
    }

    private List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.walk(out)) {
            return files.filter(file -> file.toString().endsWith(".html")).toList();
        }
    }

    private static boolean leadsSomewhere(Path page, String link) throws IOException {
        String[] parts = link.split("#", 2);
        Path target = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]);
        return Files.isRegularFile(target)
                && (parts.length == 1 || found(ID, target).contains(parts[1]));
    }

    private static List<String> found(Pattern pattern, Path page) throws IOException {
        return pattern.matcher(Files.readString(page))
                .results()
                .map((MatchResult match) -> match.group(1))
                .toList();
    }
}

package org.evoloop.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Every page of {@code docs/}, what lies beside the front page, and everything that they lead to, in the same folders
 * as in the project: a page becomes HTML, anything else is copied. Nothing is fetched, neither now nor by whoever reads
 * it.
 */
final class Site {
    /** Where Javadoc lies, if somebody has put it there. */
    static final String API = "api/index.html";

    private static final String README = "README.md";
    private static final String STYLE = "style.css";

    private final Path root;
    private final Path out;
    private final Deque<Path> waiting = new ArrayDeque<>();
    private final Set<Path> met = new HashSet<>();

    Site(Path root, Path out) {
        this.root = root.toAbsolutePath().normalize();
        this.out = out.toAbsolutePath().normalize();
    }

    /** @throws NoSuchFileException if a page names a file that is not there */
    void write() throws IOException {
        for (String page : List.of(README, "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")) {
            meet(root.resolve(page), root);
        }
        try (Stream<Path> pages = Files.walk(root.resolve("docs"), 2)) {
            for (Path page : new TreeSet<>(
                    pages.filter(page -> page.toString().endsWith(".md")).toList())) {
                meet(page, root);
            }
        }
        while (!waiting.isEmpty()) {
            write(waiting.remove());
        }
        try (InputStream style = Site.class.getResourceAsStream(STYLE)) {
            Files.copy(style, out.resolve(STYLE), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private void write(Path source) throws IOException {
        if (isPage(source)) {
            String text = Files.isDirectory(source) ? listed(source) : Files.readString(source);
            Page page = Page.of(text, destination -> led(source, destination));
            for (Path next : page.leadsTo()) {
                meet(next, source);
            }
            Path html = root.relativize(html(source));
            Files.createDirectories(out.resolve(html).resolveSibling(""));
            String home = "../".repeat(html.getNameCount() - 1);
            Files.writeString(out.resolve(html), Template.of(page, home, home + STYLE));
        } else {
            Path target = out.resolve(root.relativize(source));
            Files.createDirectories(target.resolveSibling(""));
            Files.copy(source, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private void meet(Path file, Path by) throws NoSuchFileException {
        if (!Files.exists(file)) {
            throw new NoSuchFileException(
                    root.relativize(file).toString(),
                    null,
                    "there is no such file, but a link in " + root.relativize(by));
        }
        if (met.add(file)) {
            waiting.add(file);
        }
    }

    /** What a page's link means: the file, and how its HTML is reached from the page's. */
    private Page.Target led(Path page, String path) {
        Path file = page.resolveSibling(path).normalize();
        if (Files.isRegularFile(file.resolve(README))) {
            file = file.resolve(README);
        }
        String link = html(page)
                .resolveSibling("")
                .relativize(isPage(file) ? html(file) : file)
                .toString();
        return new Page.Target(file, link);
    }

    /** A folder without a page of its own. */
    private String listed(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> "- [%1$s](%2$s/%1$s)".formatted(file.getFileName(), folder.getFileName()))
                    .sorted()
                    .collect(Collectors.joining("\n", "# " + root.relativize(folder) + "\n\n", "\n"));
        }
    }

    private static boolean isPage(Path file) {
        return file.toString().endsWith(".md") || Files.isDirectory(file);
    }

    /** A folder's front page is its index. */
    private static Path html(Path page) {
        String name = page.getFileName().toString();
        if (Files.isDirectory(page)) {
            return page.resolve("index.html");
        }
        return page.resolveSibling(name.equals(README) ? "index.html" : name.replace(".md", ".html"));
    }
}

package org.evoloop.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * A Markdown file, read.
 *
 * @param title its first heading
 * @param body as HTML
 * @param sections the headings of the second level: name by anchor, in order
 * @param leadsTo the files that it links to or shows
 */
record Page(String title, String body, Map<String, String> sections, List<Path> leadsTo) {
    private static final List<TablesExtension> EXTENSIONS = List.of((TablesExtension) TablesExtension.create());

    /**
     * Where a link leads.
     *
     * @param file in the project
     * @param link from the page's HTML
     */
    record Target(Path file, String link) {}

    /** @param targets finds where a relative path in the page leads */
    static Page of(String markdown, Function<String, Target> targets) {
        Node document = Parser.builder().extensions(EXTENSIONS).build().parse(markdown);
        Reader reader = new Reader(targets);
        document.accept(reader);
        String body = HtmlRenderer.builder()
                .extensions(EXTENSIONS)
                .attributeProviderFactory(context -> (node, tag, attributes) -> {
                    String anchor = reader.anchors.get(node);
                    if (anchor != null) {
                        attributes.put("id", anchor);
                    }
                })
                .build()
                .render(document);
        return new Page(reader.title, body, reader.sections, reader.leadsTo);
    }

    /** As GitHub makes it of a heading: lower case, hyphens for blanks, no other punctuation. */
    static String anchor(String heading) {
        return heading.toLowerCase(Locale.ROOT).replaceAll("[^\\w\\- ]", "").replace(' ', '-');
    }

    private static final class Reader extends AbstractVisitor {
        private final Function<String, Target> targets;
        private final Map<Node, String> anchors = new HashMap<>();
        private final Map<String, String> sections = new LinkedHashMap<>();
        private final List<Path> leadsTo = new ArrayList<>();
        private String title = "";

        Reader(Function<String, Target> targets) {
            this.targets = targets;
        }

        @Override
        public void visit(Heading heading) {
            String name = text(heading);
            anchors.put(heading, anchor(name));
            if (heading.getLevel() == 2) {
                sections.put(anchor(name), name);
            } else if (title.isEmpty()) {
                title = name;
            }
            visitChildren(heading);
        }

        @Override
        public void visit(Link link) {
            link.setDestination(translated(link.getDestination()));
            visitChildren(link);
        }

        @Override
        public void visit(Image image) {
            image.setDestination(translated(image.getDestination()));
            visitChildren(image);
        }

        private String translated(String destination) {
            if (destination.matches("(?i)[a-z]+:.*|#.*")) {
                return destination;
            }
            int hash = destination.indexOf('#');
            String path = hash < 0 ? destination : destination.substring(0, hash);
            Target target = targets.apply(path);
            leadsTo.add(target.file());
            return target.link() + destination.substring(path.length());
        }

        private static String text(Node heading) {
            StringBuilder text = new StringBuilder();
            heading.accept(new AbstractVisitor() {
                @Override
                public void visit(Text part) {
                    text.append(part.getLiteral());
                }

                @Override
                public void visit(Code part) {
                    text.append(part.getLiteral());
                }
            });
            return text.toString();
        }
    }
}

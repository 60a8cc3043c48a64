package org.evoloop.benchmarks.drawing;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.benchmarks.profile.Profile;
import org.evoloop.svg.Svg;

/**
 * A flame graph drawn from the top: a thread, and below each method the ones it called, with a width proportional to
 * the number of samples. A tooltip shows the full name and the share.
 */
public final class FlameGraph {
    private static final double WIDTH = 1200;
    private static final double MARGIN = 10;
    private static final double HEAD = 70;
    private static final double HEIGHT = 18;
    private static final double LETTER = 6.7;
    private static final double FONT_SIZE = 11;
    private static final double NARROWEST = 0.6;

    private static final String STYLE = """
            text { fill: #1b2733 }
            .title { font-size: 17px; font-weight: bold }
            .note { fill: #57606a; font-size: 12px }
            rect { stroke: #fff; stroke-width: 0.5 }
            .thread { fill: #d8dee4 }
            .ours { fill: #9cc7ea }
            .other { fill: #f5d491 }
            .measuring { fill: #e9ecef }
            """;

    private final Svg svg;
    private final double samples;

    private FlameGraph(Svg svg, double samples) {
        this.svg = svg;
        this.samples = samples;
    }

    /** The graph as an SVG document. */
    public static String svg(String title, Profile profile) {
        Frame root = new Frame();
        profile.samples().forEach((stack, count) -> {
            root.samples += count;
            Frame frame = root.called(stack.thread(), count);
            for (String method : stack.methods()) {
                frame = frame.called(method, count);
            }
        });
        double height = HEAD + root.depth() * HEIGHT + MARGIN;
        FlameGraph graph =
                new FlameGraph(new Svg(title, WIDTH, height, FONT_SIZE, STYLE, ""), Math.max(1, root.samples));
        graph.svg
                .text("title", MARGIN, 26, title)
                .text(
                        "note",
                        MARGIN,
                        46,
                        root.samples + " samples; as wide as seen often. Blue: Evoloop, yellow: the JDK and libraries,"
                                + " grey: threads and what measures.");
        graph.draw(root, MARGIN, HEAD);
        return graph.svg.toString();
    }

    /** A method at one place in the call tree, with the methods it called. */
    private static final class Frame {
        private final Map<String, Frame> called = new TreeMap<>();
        private long samples;

        Frame called(String name, long count) {
            Frame frame = called.computeIfAbsent(name, key -> new Frame());
            frame.samples += count;
            return frame;
        }

        int depth() {
            return called.values().stream()
                    .mapToInt(Frame::depth)
                    .map(depth -> depth + 1)
                    .max()
                    .orElse(0);
        }
    }

    private void draw(Frame caller, double left, double top) {
        double x = left;
        for (Map.Entry<String, Frame> entry : caller.called.entrySet()) {
            Frame frame = entry.getValue();
            double width = frame.samples / samples * (WIDTH - 2 * MARGIN);
            if (width >= NARROWEST) {
                draw(entry.getKey(), frame.samples, x, top, width);
                draw(frame, x, top + HEIGHT);
            }
            x += width;
        }
    }

    private void draw(String name, long count, double x, double top, double width) {
        svg.groupWithTip(String.format(Locale.ROOT, "%s: %.1f %%", name, 100 * count / samples));
        svg.rectangle(kind(name, top), x, top, width, HEIGHT, 0);
        String shown = shorten(name, (int) ((width - 6) / LETTER));
        if (!shown.isEmpty()) {
            svg.text("name", x + 3, top + 13, shown);
        }
        svg.endGroup();
    }

    private static String kind(String name, double top) {
        if (top == HEAD) {
            return "thread";
        }
        if (name.startsWith("org.evoloop.benchmarks.")) {
            return "measuring";
        }
        return name.startsWith("org.evoloop.") ? "ours" : "other";
    }

    /** Class and method, as far as they fit: {@code Monitor.run} for {@code org.evoloop.loop.Monitor.run}. */
    static String shorten(String name, int letters) {
        List<String> words = List.of(name.split("\\.", -1));
        String classAndMethod = String.join(".", words.subList(Math.max(0, words.size() - 2), words.size()));
        String method = words.get(words.size() - 1);
        if (classAndMethod.length() <= letters) {
            return classAndMethod;
        }
        return method.length() <= letters ? method : "";
    }
}

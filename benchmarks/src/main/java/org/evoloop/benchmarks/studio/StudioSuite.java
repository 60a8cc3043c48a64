package org.evoloop.benchmarks.studio;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Started;
import org.evoloop.benchmarks.report.Suite;

/** How long the studio takes for the picture and the findings of the Roomba's largest model, while it is typed. */
public final class StudioSuite implements Suite {
    private static final Path TOOL = Path.of("framework", "models", "target", "evoloop-models.jar");
    private static final int WARM = 40;
    private static final double PICTURE_MILLIS = 150;
    private static final double FINDINGS_MILLIS = 500;

    @Override
    public String name() {
        return "studio";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        Path folder = Files.createTempDirectory("evoloop-studio");
        Path original = folder.resolve("original.mmd");
        Process studio = null;
        try {
            Files.writeString(original, mermaid("original"));
            String home = mermaid("home");
            studio = Started.begin(TOOL, Fork.STUDIO_OPTIONS, "studio", folder.toString(), "--port", "0");
            BufferedReader printed = studio.inputReader(StandardCharsets.UTF_8);
            String address = printed.readLine();
            if (address == null) {
                throw new IOException("the studio did not start");
            }
            return typed(new TypingPage(address), home, quick ? 40 : 200);
        } finally {
            if (studio != null) {
                studio.destroy();
                studio.waitFor();
            }
            Files.deleteIfExists(original);
            Files.delete(folder);
        }
    }

    private static List<Row> typed(TypingPage page, String home, int keys) throws IOException, InterruptedException {
        double[] pictures = new double[keys];
        double[] findings = new double[keys];
        for (int key = -WARM; key < keys; key++) {
            // Each key makes another machine, so that no answer is one that was there before.
            int number = key + WARM;
            String text = home + "    Off --> On : e" + number + "x".repeat(number % 12) + "\n";
            double drawn = page.ask("/api/draw", text);
            // The page asks for the findings when it has the picture.
            double checked = drawn + page.ask("/api/check", text);
            if (key >= 0) {
                pictures[key] = drawn;
                findings[key] = checked;
            }
        }
        return List.of(
                row("a key typed in home to its picture, without the quiet before", pictures, PICTURE_MILLIS),
                row("the same to its findings", findings, FINDINGS_MILLIS));
    }

    private static Row row(String what, double[] millis, double most) {
        Arrays.sort(millis);
        return new Row(
                what + ", 95th percentile",
                "ms",
                millis[(int) Math.ceil(millis.length * 0.95) - 1],
                Row.Goal.atMost(most),
                Map.of("median", millis[millis.length / 2]));
    }

    private static String mermaid(String machine) throws IOException, InterruptedException {
        Path models = Path.of(System.getProperty("evoloop.home", ""), "models", "roomba.xml");
        Process tool = Started.begin(TOOL, "show", models + "#" + machine, "--format", "mermaid");
        try (InputStream written = tool.getInputStream()) {
            String text = new String(written.readAllBytes(), StandardCharsets.UTF_8);
            if (tool.waitFor() != 0) {
                throw new IOException(machine + " could not be read from " + models);
            }
            return text;
        }
    }
}

package org.evoloop.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.page.drawing.MachineDrawing;

/**
 * A picture of a new model that needs no page around it, for other programs that show it, such as Home Assistant.
 *
 * <p>Threading: pure functions, which any thread may call.
 *
 * @since 0.1
 */
public final class ModelPicture {
    /** In a wider one, a card shows no text that could be read. */
    private static final int WIDEST = 900;

    private static final String HEADS =
            head("arrow") + head("arrow-new") + "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>";

    private ModelPicture() {}

    /**
     * The new model, in which what it has beyond the original one is marked, as SVG in the colours of the light page. If all
     * of it is too wide, only that is drawn.
     *
     * @return empty if the model is too large to be drawn
     */
    public static String of(ModelPair models) {
        return MachineDrawing.ofNew(models, WIDEST)
                .replaceFirst("<svg ([^>]*)>", "<svg class=\"chart\" data-theme=\"light\" $1>" + style() + HEADS);
    }

    private static String head(String id) {
        return "<marker id=\"" + id
                + "\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"10\" markerHeight=\"10\" "
                + "markerUnits=\"userSpaceOnUse\" orient=\"auto\"><path d=\"M0 1 L9 5 L0 9\" fill=\"none\" "
                + "stroke-width=\"1.6\"/></marker>";
    }

    /** The colours of the page, and its rules for drawings. */
    private static String style() {
        String sheet;
        try (InputStream file = Objects.requireNonNull(ModelPicture.class.getResourceAsStream("style.css"))) {
            sheet = new String(file.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
        int colours = sheet.indexOf(":root {");
        String rules = sheet.lines()
                .filter(line -> line.startsWith(".chart") || line.startsWith(".arrows path"))
                .map(line -> line.replace(".arrows path {", "marker path {"))
                .collect(Collectors.joining("\n"));
        return ("<style>" + sheet.substring(colours, sheet.indexOf('}', colours) + 1)
                        + "\n[data-theme] { color-scheme: light; }\n" + rules + "</style>")
                .replace("$", "\\$");
    }
}

package org.evoloop.models;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.evoloop.console.Console;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.learn.LearnProgress;
import org.evoloop.learn.Learned;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.page.Picture;
import org.evoloop.statechart.FlatDrawing;
import org.jspecify.annotations.Nullable;

/**
 * How far learning is: a line of text, and the states so far as a picture on the live page of the converter that operates the
 * device.
 *
 * <p>Threading: told by the thread that learns, shown on the page's.
 */
final class LearnPage implements LearnProgress, AutoCloseable {
    private final Duration budget;
    private final Page page;
    private volatile @Nullable Moment now;

    /** What was told last. */
    private record Moment(Learned soFar, int expected) {}

    /**
     * Serves the page, if the options say so; its address goes to stderr.
     *
     * @param converter that operates the device
     * @param budget how long learning may take
     */
    LearnPage(PageOptions options, SystemEventConverter converter, Duration budget) throws IOException {
        this.budget = budget;
        // The page acts through a console, which nobody types at.
        Console console = new Console(converter, InputStream.nullInputStream(), System.err, System.err);
        page = Page.open(
                options,
                console,
                System.err,
                List.of(new Picture(
                        "Learned so far", "The states and transitions found so far.", "image/svg+xml", this::view)));
    }

    @Override
    public void at(Learned soFar, int expected) {
        now = new Moment(soFar, expected);
    }

    private Picture.View view() {
        Moment moment = now;
        return moment == null || moment.soFar().states().isEmpty()
                ? new Picture.View(new byte[0], "Nothing is known yet.")
                : new Picture.View(drawing(moment.soFar()).getBytes(StandardCharsets.UTF_8), line(moment));
    }

    private static String drawing(Learned soFar) {
        return SvgWriter.write(
                "learned so far", List.of(ChartDiagram.of(FlatDrawing.of(soFar.model("learned so far")))));
    }

    /** How far it is, such as {@code 4 states, 31 words, at most 12 more; 80 s, at most 3520 s more}. */
    String line() {
        return line(requireNonNull(now, "nothing was told yet"));
    }

    private String line(Moment moment) {
        Learned soFar = moment.soFar();
        Duration left = budget.minus(soFar.took());
        return soFar.states().size() + " states, " + soFar.words() + " words, at most " + moment.expected()
                + " more if these are all; " + soFar.took().toSeconds() + " s, at most "
                + Math.max(0, left.toSeconds()) + " s more";
    }

    @Override
    public void close() {
        page.close();
    }
}

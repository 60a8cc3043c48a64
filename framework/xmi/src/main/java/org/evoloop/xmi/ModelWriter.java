package org.evoloop.xmi;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.evoloop.statechart.Flattening;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.dialect.DrawnChart;
import org.evoloop.xmi.scxml.ScxmlWriter;
import org.evoloop.xmi.text.MermaidWriter;

/**
 * Writes charts in the languages that {@link ModelFile} reads. What is written is read again: a machine is written only if
 * it would then be the same.
 *
 * <p>Threading: pure functions, which any thread may call.
 *
 * @since 0.1
 */
public enum ModelWriter {
    /** A state diagram of Mermaid. */
    MERMAID("Mermaid", ".mmd"),
    /** State Chart XML. */
    SCXML("SCXML", ".scxml");

    private static final int LISTED = 20;

    private final String label;
    private final String extension;

    ModelWriter(String label, String extension) {
        this.label = label;
        this.extension = extension;
    }

    /**
     * The chart as text. Reading it gives a chart with the same flat machine; of a chart that has none, the elements are
     * written as they are drawn.
     *
     * @throws ModelException if the language has no words for something in it; the message gives every reason, one line
     *     each
     */
    public String write(Statechart chart) {
        DrawnChart drawn = new DrawnChart(chart);
        List<String> reasons =
                new ArrayList<>(this == MERMAID ? MermaidWriter.unsayable(drawn) : ScxmlWriter.unsayable(drawn));
        if (!reasons.isEmpty()) {
            throw refusal(chart, reasons);
        }
        String text;
        try {
            text = this == MERMAID ? MermaidWriter.write(drawn) : ScxmlWriter.write(drawn);
        } catch (ModelException noWords) {
            throw refusal(chart, List.of(String.valueOf(noWords.getMessage())));
        }
        Flattening flat = Flattening.of(chart);
        if (flat.problems().isEmpty()) {
            difference(flat.machine(), text).ifPresent(reasons::add);
        } else if (this == SCXML && chart.semantics() == Statechart.Semantics.UML) {
            flat.problems().forEach(problem -> reasons.add(problem.toString()));
        }
        if (!reasons.isEmpty()) {
            throw refusal(chart, reasons);
        }
        return text;
    }

    private ModelException refusal(Statechart chart, List<String> reasons) {
        List<String> all = reasons.stream().distinct().toList();
        return new ModelException("state machine '" + chart.name() + "' cannot be written in " + label + ": "
                + (all.size() == 1
                        ? all.get(0)
                        : all.stream()
                                .limit(LISTED)
                                .map(reason -> "\n  " + reason)
                                .collect(Collectors.joining()))
                + (all.size() > LISTED ? "\n  and " + (all.size() - LISTED) + " more" : ""));
    }

    private Optional<String> difference(StateMachine machine, String text) {
        StateMachine read;
        try {
            read = ModelFile.read(
                            "written" + extension, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)))
                    .only();
        } catch (ModelException unreadable) {
            return Optional.of("what would be written cannot be read again: " + unreadable.getMessage());
        }
        return SameMachine.difference(machine, read).map(what -> "it would mean something else there: " + what);
    }
}

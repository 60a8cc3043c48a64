package org.evoloop.models.studio;

import java.util.List;
import java.util.Map;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.Layouts;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.payload.JsonObject;
import org.evoloop.studio.Analysis;
import org.evoloop.studio.Pair;

/**
 * What the studio says about models.
 *
 * <p>Threading: thread-safe.
 */
public final class StudioAnalysis implements Analysis {
    private final Layouts layouts = new Layouts();

    /** Loads what draws, which takes longer than a picture. */
    public void prepare() {
        Node node = new Node("prepared", Shape.STATE, "prepared", List.of(), List.of(), Tone.PLAIN, Map.of());
        SvgWriter.plain("prepared", new Diagram("prepared", List.of(node), List.of()), true, layouts);
    }

    @Override
    public JsonObject draw(Pair pair, View view) {
        return Pictures.draw(pair, view, layouts);
    }

    @Override
    public JsonObject check(Pair pair, Written properties) {
        return Findings.check(pair, properties);
    }

    @Override
    public JsonObject plan(Pair pair, String state, String event, String guard) {
        return Plans.plan(pair, state, event, guard);
    }

    @Override
    public JsonObject migrate(Pair running, Pair next) {
        return Migrations.table(running, next);
    }

    @Override
    public JsonObject property(Pair pair, String property) {
        return Judged.property(pair, property);
    }
}

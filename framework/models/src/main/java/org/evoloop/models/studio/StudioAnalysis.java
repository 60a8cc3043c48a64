package org.evoloop.models.studio;

import java.util.List;
import org.evoloop.payload.JsonObject;
import org.evoloop.studio.Analysis;
import org.evoloop.studio.Pair;

/**
 * What the studio says about models.
 *
 * <p>Threading: thread-safe.
 */
public final class StudioAnalysis implements Analysis {
    @Override
    public JsonObject draw(Pair pair, View view) {
        return Pictures.draw(pair, view);
    }

    @Override
    public JsonObject check(Pair pair, String properties) {
        return new JsonObject().put("findings", List.<JsonObject>of());
    }

    @Override
    public JsonObject plan(Pair pair, String state, String event, String guard) {
        return new JsonObject().put("words", "").put("steps", List.<JsonObject>of());
    }

    @Override
    public JsonObject property(Pair pair, String property) {
        return new JsonObject().put("holds", true).put("words", "").put("run", List.<JsonObject>of());
    }
}

package org.evoloop.models.studio;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Turn;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.Event;

/** A sequence of events as inputs of a run that can be tried. */
final class Played {
    private Played() {}

    /** The inputs; what a function sends is none. */
    static List<JsonObject> of(List<Turn> turns, DecisionTable table) {
        List<JsonObject> run = new ArrayList<>();
        for (Turn turn : turns) {
            Event event = turn.event();
            event.guards().forEach(guard -> guard(run, guard));
            if (event.timeTrigger().isPresent()) {
                run.add(new JsonObject().put("after", event.timeTrigger().get().toMillis() + " ms"));
            } else if (!turn.isSent()) {
                boolean own = turn.deviceActed() || table.isDevicesOwn(event.trigger());
                run.add(new JsonObject()
                        .put(own ? "device" : "press", event.trigger().name()));
            }
        }
        return run;
    }

    private static void guard(List<JsonObject> run, String guard) {
        if (!guard.equals("else")) {
            run.add(new JsonObject().put("guard", guard).put("value", true));
        }
    }
}

package org.evoloop.models.evolution;

import org.evoloop.migration.Fate;
import org.evoloop.models.diagram.Diagram.Tone;

/** What becomes of a pair of states, from the best to the worst. */
enum FateKind {
    MAPS(Tone.PLAIN, "maps"),
    SENDS(Tone.SENDING, "sends"),
    WAITS(Tone.WAITING, "waits"),
    IMPOSSIBLE(Tone.STUCK, "impossible");

    private final Tone tone;
    private final String key;

    FateKind(Tone tone, String key) {
        this.tone = tone;
        this.key = key;
    }

    static FateKind of(Fate fate) {
        if (fate instanceof Fate.Maps maps) {
            return maps.steps().isEmpty() ? MAPS : SENDS;
        }
        return fate instanceof Fate.Waits ? WAITS : IMPOSSIBLE;
    }

    /** How it is drawn. */
    Tone tone() {
        return tone;
    }

    /** What it is called in JSON. */
    String key() {
        return key;
    }
}

package org.evoloop.models.evolution;

import org.evoloop.migration.Fate;
import org.evoloop.models.diagram.Diagram.Tone;

/** What a swap does in a pair of states, from best to worst. */
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

    /** The tone in which it is drawn. */
    Tone tone() {
        return tone;
    }

    /** Its name in JSON. */
    String key() {
        return key;
    }
}

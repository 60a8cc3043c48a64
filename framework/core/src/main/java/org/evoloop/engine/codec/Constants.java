package org.evoloop.engine.codec;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.evoloop.engine.Work;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Source;

/** The words for an enum's constants. */
final class Constants<E extends Enum<E>> {
    static final Constants<Source> SOURCES = new Constants<>(Source.values());
    static final Constants<Work.Stage> STAGES = new Constants<>(Work.Stage.values());
    static final Constants<OnFailure> ON_FAILURE = new Constants<>(OnFailure.values());

    private final Map<E, String> words = new HashMap<>();
    private final Map<String, E> constants = new HashMap<>();

    private Constants(E[] all) {
        for (E each : all) {
            String word = each.name().toLowerCase(Locale.ROOT);
            words.put(each, word);
            constants.put(word, each);
        }
    }

    String word(E constant) {
        return words.getOrDefault(constant, "");
    }

    /** Reads one. */
    E read(Items items) {
        String word = items.word();
        E known = constants.get(word);
        if (known == null) {
            throw items.damaged("'" + word + "' is none of "
                    + constants.keySet().stream().sorted().toList());
        }
        return known;
    }
}

package org.evoloop.engine.codec;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The numbers of words in bytes. Stored bytes contain them: never change a number, and add words only at the end. */
final class WordCodes {
    /** Stands for a word without a number, which is written out. */
    static final int OTHER = 0;

    private static final List<String> WORDS = List.of(
            "heard",
            "asked",
            "found",
            "in-doubt",
            "violated",
            "evolved",
            "controller",
            "panel",
            "device",
            "function",
            "owner",
            "timer",
            "property",
            "ready",
            "sending",
            "running",
            "interrupted",
            "resumed",
            "stay",
            "go_back",
            "other_way",
            "not-acceptable",
            "existing-function",
            "new-function",
            "resynchronization",
            "inquiry",
            "refused",
            "impossible",
            "none");
    private static final Map<String, Integer> CODES = new HashMap<>();

    static {
        for (String word : WORDS) {
            CODES.put(word, CODES.size() + 1);
        }
    }

    private WordCodes() {}

    static int of(String word) {
        return CODES.getOrDefault(word, OTHER);
    }

    static boolean isKnown(int code) {
        return code > OTHER && code <= WORDS.size();
    }

    static String word(int code) {
        return WORDS.get(code - 1);
    }
}

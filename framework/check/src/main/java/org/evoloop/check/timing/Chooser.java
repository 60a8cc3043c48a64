package org.evoloop.check.timing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Answers questions that are open beforehand, such as whether a guard holds, in every possible way. */
final class Chooser {
    private final List<Boolean> answers = new ArrayList<>();
    private final Map<String, Boolean> given = new HashMap<>();
    private int asked;

    /** The same question has the same answer until the next {@link #anew}. */
    boolean choose(String question) {
        return given.computeIfAbsent(question, any -> {
            if (asked == answers.size()) {
                answers.add(false);
            }
            return answers.get(asked++);
        });
    }

    /** From now on answers may be others. */
    void anew() {
        given.clear();
    }

    /** Begins the next way to answer all; false if there is none. */
    boolean next() {
        given.clear();
        asked = 0;
        while (!answers.isEmpty() && answers.get(answers.size() - 1)) {
            answers.remove(answers.size() - 1);
        }
        if (answers.isEmpty()) {
            return false;
        }
        answers.set(answers.size() - 1, true);
        return true;
    }
}

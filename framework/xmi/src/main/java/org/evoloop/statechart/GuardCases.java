package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Enumerates the values of the guards that are evaluated during one event. The cases in which the first guard holds
 * come first. So of several outcomes, the first one whose guards all hold is the right one, and the guards that did not
 * hold need not be recorded.
 */
final class GuardCases {
    private final List<Boolean> plan = new ArrayList<>();
    private final Map<String, Boolean> asked = new LinkedHashMap<>();

    /** The value of a guard, the same for the whole event. */
    boolean holds(String guard) {
        return asked.computeIfAbsent(guard, text -> {
            if (asked.size() == plan.size()) {
                plan.add(true);
            }
            return plan.get(asked.size());
        });
    }

    /** The guards that were evaluated and hold, in the order of evaluation. */
    List<String> held() {
        return asked.entrySet().stream()
                .filter(Map.Entry::getValue)
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Whether there are further values. If so, the event must be run again with them. */
    boolean next() {
        asked.clear();
        while (!plan.isEmpty() && !plan.get(plan.size() - 1)) {
            plan.remove(plan.size() - 1);
        }
        if (plan.isEmpty()) {
            return false;
        }
        plan.set(plan.size() - 1, false);
        return true;
    }
}

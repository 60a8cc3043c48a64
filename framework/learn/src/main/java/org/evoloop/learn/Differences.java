package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.learn.Heard.Reply;
import org.evoloop.learn.Learned.Arrow;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Compares what was seen with a declared model, in both at once from where every word begins. */
final class Differences {
    private final Learned learned;
    private final StateMachine declared;
    private final Duration longest;
    private final Map<String, State> same = new HashMap<>();
    private final List<String> lines = new ArrayList<>();

    Differences(Learned learned, StateMachine declared, Duration longest) {
        this.learned = learned;
        this.declared = declared;
        this.longest = longest;
        for (String name : learned.states()) {
            if (declared.hasState(new State(name))) {
                same.put(name, new State(name));
            }
        }
        String begin = learned.states().get(0);
        State initial = declared.initial();
        if (!same.computeIfAbsent(begin, none -> initial).equals(initial)) {
            lines.add("it begins in " + begin + ", and " + initial + " is declared");
        }
    }

    List<String> lines() {
        List<Arrow> open = new ArrayList<>(learned.edges());
        boolean found = true;
        while (found) {
            found = false;
            for (Arrow arrow : List.copyOf(open)) {
                State source = same.get(arrow.source());
                if (source != null) {
                    open.remove(arrow);
                    compare(source, arrow);
                    found = true;
                }
            }
        }
        return List.copyOf(lines);
    }

    private void compare(State source, Arrow arrow) {
        Reply reply = arrow.heard().reply();
        if (reply == Reply.FORBIDDEN || reply == Reply.UNANSWERED) {
            return;
        }
        Transition drawn = drawn(source, arrow);
        State expected = drawn == null ? source : drawn.target();
        if (reply == Reply.SILENT || reply == Reply.REFUSED) {
            if (drawn != null) {
                lines.add(drawn + " is declared, and was " + (reply == Reply.SILENT ? "not seen" : "refused"));
            }
            return;
        }
        State seen = same.get(arrow.target());
        if (seen == null) {
            boolean isNew = drawn == null || same.containsValue(expected);
            if (!isNew) {
                same.put(arrow.target(), expected);
                return;
            }
        } else if (seen.equals(expected)) {
            return;
        }
        String edge = source + " --" + Learned.trigger(arrow) + "--> " + (seen == null ? arrow.target() : seen);
        lines.add(drawn == null ? edge + " is not declared" : drawn + " is declared, and " + edge + " was seen");
    }

    /** What the model has for an answer; null if it has nothing. */
    private @Nullable Transition drawn(State source, Arrow arrow) {
        List<String> acts = arrow.heard().acts();
        if (!arrow.input().equals(LearnedDevice.WAIT)) {
            return declared.transition(source, new Event(arrow.input())).orElse(null);
        }
        return acts.isEmpty()
                ? declared.transitionsFrom(source).stream()
                        .filter(transition -> isTimed(transition.event()))
                        .findFirst()
                        .orElse(null)
                : declared.transition(source, new Event(acts.get(0))).orElse(null);
    }

    private boolean isTimed(Event event) {
        Optional<Duration> time = event.timeTrigger();
        return time.isPresent() && time.get().compareTo(longest) < 0;
    }
}

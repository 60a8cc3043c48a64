package org.evoloop.evolution;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * A state of the device that the new model lacks, against Condition 2 of the paper's Definition IV.1: S_o is a subset
 * of S_n.
 *
 * <p>Threading: immutable.
 *
 * @param instead what the new model has in its place, at most {@value #LISTED} items; empty if {@link Matter#ABSENT}
 * @since 0.1
 */
public record MissingState(State state, Matter matter, List<State> instead) implements ModelPair.Violation {
    private static final int LISTED = 4;

    public MissingState {
        instead = List.copyOf(instead);
    }

    /** The reason why the state is missing. */
    public enum Matter {
        /** It is drawn beside another region, so that it is active together with states of that region. */
        BESIDE_REGION(
                "draw what is new as states of its own, outside of the device's: states of two regions at once are no"
                        + " states of the device"),
        /** States are drawn inside it. */
        DIVIDED("leave it without states inside, and draw what is new as states of its own beside it"),
        /** Several states have its name. */
        AMBIGUOUS("leave it where it is in the original model, or give the others other names"),
        /** Only the spelling differs. */
        SPELLED("write it as in the original model, capital letters and spaces included"),
        /** No state resembles it. */
        ABSENT("draw it there under the same name, capital letters included");

        private final String remedy;

        Matter(String remedy) {
            this.remedy = remedy;
        }

        /** How the model's author can fix it. */
        public String remedy() {
            return remedy;
        }
    }

    /** @param state a state of the device for which {@code evolved} has no state of the same name */
    static MissingState of(State state, StateMachine original, StateMachine evolved) {
        List<String> wanted = original.paths(state);
        for (Matter matter : Matter.values()) {
            List<State> like = evolved.states().stream()
                    .filter(other -> isLike(wanted, evolved.paths(other), matter))
                    .limit(LISTED)
                    .toList();
            if (!like.isEmpty()) {
                return new MissingState(state, matter, like);
            }
        }
        return new MissingState(state, Matter.ABSENT, List.of());
    }

    private static boolean isLike(List<String> wanted, List<String> other, Matter matter) {
        return switch (matter) {
            case BESIDE_REGION ->
                other.size() > wanted.size()
                        && wanted.stream()
                                .allMatch(path -> other.stream()
                                        .anyMatch(leaf -> simple(leaf).equals(simple(path))));
            case DIVIDED ->
                wanted.stream()
                        .allMatch(path ->
                                other.stream().anyMatch(leaf -> ("." + leaf).contains("." + simple(path) + ".")));
            case AMBIGUOUS -> simple(wanted).equals(simple(other));
            case SPELLED -> spelled(wanted).equals(spelled(other));
            case ABSENT -> false;
        };
    }

    private static String simple(String path) {
        return path.substring(path.lastIndexOf('.') + 1);
    }

    private static List<String> simple(List<String> paths) {
        return paths.stream().map(MissingState::simple).toList();
    }

    private static List<String> spelled(List<String> paths) {
        return paths.stream()
                .map(path -> simple(path).toLowerCase(Locale.ROOT).replaceAll("[\\s_-]+", ""))
                .toList();
    }

    /**
     * For messages: {@code state On of the original model stands beside another region in the new model: (On, Idle)}.
     */
    public String message() {
        String there = instead.stream().map(State::name).collect(Collectors.joining(", "));
        String subject = "state " + state + " of the original model ";
        return subject
                + switch (matter) {
                    case BESIDE_REGION -> "stands beside another region in the new model: " + there;
                    case DIVIDED -> "has states inside in the new model: " + there;
                    case AMBIGUOUS -> "may be any of these in the new model: " + there;
                    case SPELLED -> "is missing in the new model, which has " + there;
                    case ABSENT -> "is missing in the new model";
                };
    }

    @Override
    public String toString() {
        return "Condition 2: "
                + (matter == Matter.ABSENT
                        ? "state " + state + " is missing in the new model"
                        : message() + "; " + matter.remedy());
    }
}

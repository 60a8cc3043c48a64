package org.evoloop.statechart;

import java.math.BigInteger;
import org.evoloop.statechart.Vertex.Kind;
import org.jspecify.annotations.Nullable;

/**
 * An upper bound for the size of a flat machine, computed without building it. Orthogonal regions multiply, and so does
 * what histories remember. The machine may be far smaller if regions change together.
 */
final class SizeEstimate {
    private static final int DIGITS_WRITTEN = 15;

    private final BigInteger states;
    private final BigInteger transitions;
    private BigInteger memories = BigInteger.ONE;
    private @Nullable Node widest;
    private BigInteger widestStates = BigInteger.ZERO;

    SizeEstimate(Net net) {
        Size whole = new Size(BigInteger.ONE, BigInteger.ZERO);
        for (Zone top : net.tops()) {
            whole = whole.beside(size(top));
        }
        states = whole.states().multiply(memories);
        BigInteger each = whole.transitions().multiply(memories);
        transitions = each.min(states.multiply(BigInteger.valueOf(net.triggers().size())));
    }

    private record Size(BigInteger states, BigInteger transitions) {
        /** The size if both are active at the same time. */
        Size beside(Size other) {
            return new Size(
                    states.multiply(other.states),
                    transitions.multiply(other.states).add(other.transitions.multiply(states)));
        }

        /** The size if one of them is active. */
        Size or(Size other) {
            return new Size(states.add(other.states), transitions.add(other.transitions));
        }
    }

    private Size size(Zone zone) {
        Size sum = new Size(BigInteger.ZERO, BigInteger.ZERO);
        long kept = 1;
        long simple = 0;
        long ofSimple = 0;
        for (Node node : zone.nodes) {
            if (!node.isPseudostate() || node.is(Kind.TERMINATE)) {
                kept++;
                if (node.zones.isEmpty() && node.activities().isEmpty()) {
                    simple++;
                    ofSimple += node.triggerCount();
                } else {
                    sum = sum.or(size(node));
                }
            }
        }
        sum = sum.or(new Size(BigInteger.valueOf(simple), BigInteger.valueOf(ofSimple)));
        if (zone.hasHistory) {
            boolean deep = zone.nodes.stream().anyMatch(node -> node.is(Kind.DEEP_HISTORY));
            memories = memories.multiply(deep ? sum.states().add(BigInteger.ONE) : BigInteger.valueOf(kept));
        }
        // An empty region does not change the size of the regions beside it.
        return sum.states().signum() == 0 ? new Size(BigInteger.ONE, BigInteger.ZERO) : sum;
    }

    private Size size(Node node) {
        Size inside = new Size(BigInteger.ONE, BigInteger.ZERO);
        for (Zone zone : node.zones) {
            inside = inside.beside(size(zone));
        }
        if (node.zones.size() > 1 && inside.states().compareTo(widestStates) > 0) {
            widest = node;
            widestStates = inside.states();
        }
        if (node.wantsCompletion() && !node.activities().isEmpty()) {
            inside = inside.or(inside);
        }
        BigInteger own = inside.states().multiply(BigInteger.valueOf(node.triggerCount()));
        return new Size(inside.states(), inside.transitions().add(own));
    }

    boolean exceeds(long mostStates, long mostTransitions) {
        return states.compareTo(BigInteger.valueOf(mostStates)) > 0
                || transitions.compareTo(BigInteger.valueOf(mostTransitions)) > 0;
    }

    /** The state with the most combinations of orthogonal regions; null if there is none. */
    @Nullable
    Node widest() {
        return widest;
    }

    /** For messages. */
    @Override
    public String toString() {
        return "up to " + written(states) + " states and " + written(transitions) + " transitions";
    }

    private static String written(BigInteger number) {
        String digits = number.toString();
        return digits.length() <= DIGITS_WRITTEN ? digits : "10^" + (digits.length() - 1);
    }
}

package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.statechart.Vertex.ChartState;
import org.jspecify.annotations.Nullable;

/**
 * What the states that are active together have to do with the device. Of states inside each other, the innermost one
 * with a device state counts; regions that are active together must agree.
 *
 * @param source the drawn state that gives the device state; null if none does
 * @param inherited whether that is only around the innermost states
 * @param sends of all of them, outer ones first
 */
record ActiveUse(@Nullable Node source, boolean inherited, List<String> sends) {
    private static final ActiveUse NONE = new ActiveUse(null, false, List.of());

    /** @throws Refused if regions contradict each other */
    static ActiveUse of(Net net, int[] leaves) {
        Set<Node> sources = new LinkedHashSet<>();
        Set<String> sends = new LinkedHashSet<>();
        for (int leaf : leaves) {
            List<Node> chain = new ArrayList<>();
            for (Node node = net.node(leaf); node != null; node = node.zone.owner) {
                chain.add(node);
            }
            chain.stream()
                    .filter(node -> !drawnAt(node).device().isEmpty())
                    .findFirst()
                    .ifPresent(sources::add);
            for (int i = chain.size() - 1; i >= 0; i--) {
                sends.addAll(drawnAt(chain.get(i)).sends());
            }
        }
        // An inner one wins, in whichever region it is.
        List<Node> innermost = sources.stream()
                .filter(node -> sources.stream().noneMatch(other -> other != node && node.holds(other)))
                .toList();
        if (innermost.isEmpty()) {
            return sends.isEmpty() ? NONE : new ActiveUse(null, false, List.copyOf(sends));
        }
        Node first = innermost.get(0);
        for (Node other : innermost) {
            if (!drawnAt(other).device().equals(drawnAt(first).device())) {
                throw contradiction(first, other);
            }
        }
        boolean inherited = innermost.stream().allMatch(node -> !node.zones.isEmpty());
        return new ActiveUse(first, inherited, List.copyOf(sends));
    }

    /** The state of the original in which the device must be; empty for any. */
    String device() {
        return source == null ? "" : drawnAt(source).device();
    }

    /** What is drawn at one state. */
    static DeviceUse drawnAt(Node node) {
        return node.vertex instanceof ChartState state ? state.use() : DeviceUse.NONE;
    }

    private static Refused contradiction(Node one, Node other) {
        return new Refused(
                other.vertex.place(),
                "the device must be in " + drawnAt(one).device() + " in " + one + " and in "
                        + drawnAt(other).device() + " in "
                        + other + ", which are active together in regions " + region(one, other) + " and "
                        + region(other, one),
                "let them agree, or give only one of them a device state");
    }

    /** The region in which {@code node} is and {@code other} is not. */
    private static String region(Node node, Node other) {
        Zone zone = node.zone;
        while (zone.owner != null && !zone.owner.holds(other)) {
            zone = zone.owner.zone;
        }
        String name = zone.region.name();
        return name.isEmpty()
                ? "'"
                        + zone.nodes.stream()
                                .filter(Node::isState)
                                .map(Node::simpleName)
                                .findFirst()
                                .orElse("") + "...'"
                : "'" + name + "'";
    }
}

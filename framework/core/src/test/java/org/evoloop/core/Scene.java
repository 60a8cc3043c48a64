package org.evoloop.core;

import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.PaperModels;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * What is explored: a pair with its timers, and how often each thing may happen from outside.
 *
 * @param inOrder whether the adapter tells effects of steps in their place among what the device does by itself
 * @param canLocate whether the device can tell where it is
 */
record Scene(
        String name,
        Rules rules,
        Set<Event> presses,
        Set<Event> own,
        Set<Event> raised,
        boolean inOrder,
        boolean canLocate,
        Map<Act, Integer> times) {

    /** What may happen from outside, and is counted. */
    enum Act {
        /** A controller's event. */
        PRESS,
        /** The device does by itself what its model knows. */
        OWN,
        /** The device gets somewhere by itself, and is found there. */
        JUMP,
        /** A function or a late timer raises an event, maybe of the visit before. */
        RAISE,
        /** A function asks for an event of the device. */
        ASK,
        /** The converter is closed, or opened again. */
        STOP,
        /** Components are exchanged. */
        CHANGE,
        /** A component fails. */
        FAIL,
        /** A component is given up. */
        GIVE_UP,
        /** Analyze or plan dismisses an occurrence or refuses it by a rule of its own. */
        DISMISS,
        /** The process ends at once, and another one takes the core over. */
        END
    }

    static Scene robot() {
        return of("robot", PaperModels.cleaningRobot(), Map.of("SpotWait", "timeout"), "Clean Spot", "Clean Spot", 2);
    }

    static Scene bulb() {
        return of("bulb", PaperModels.lightBulb(), Map.of("wait", "timeout"), "switch", "switch", 2);
    }

    /**
     * A scene in which nothing happens.
     *
     * @param timers a time event for each state that has one
     * @param sendable names with blanks between
     * @param spontaneous the same for those that the device does by itself although they can be sent
     */
    static Scene of(
            String name,
            ModelPair pair,
            Map<String, String> timers,
            String sendable,
            String spontaneous,
            int queueCapacity) {
        Set<Event> sent = events(sendable);
        Set<Event> own = events(spontaneous);
        DecisionTable table = DecisionTable.compile(pair, new DeviceEvents(sent, own));
        pair.original().triggers().stream()
                .filter(event -> !sent.contains(event))
                .forEach(own::add);
        Set<Event> raised = pair.evolved().triggers().stream()
                .filter(event -> !pair.original().triggers().contains(event))
                .collect(Collectors.toSet());
        Rules rules = new Rules(table, state -> timersOf(timers, state), queueCapacity);
        return new Scene(name, rules, sent, own, raised, true, true, Map.of());
    }

    private static Map<Event, Duration> timersOf(Map<String, String> timers, State state) {
        String event = timers.get(state.name());
        return event == null ? Map.of() : Map.of(new Event(event), Duration.ofSeconds(5));
    }

    private static Set<Event> events(String names) {
        return Stream.of(names.split(" ")).map(Event::new).collect(Collectors.toSet());
    }

    /** The same in which {@code act} may happen so often. */
    Scene with(Act act, int most) {
        Map<Act, Integer> more = new EnumMap<>(Act.class);
        more.putAll(times);
        more.put(act, most);
        return new Scene(name, rules, presses, own, raised, inOrder, canLocate, more);
    }

    Scene with(int most, Act... acts) {
        Scene scene = this;
        for (Act act : acts) {
            scene = scene.with(act, most);
        }
        return scene;
    }

    /** The same with an adapter that tells an effect when {@code send} returns. */
    Scene outOfOrder() {
        return new Scene(name, rules, presses, own, raised, false, canLocate, times);
    }

    /** The same with a device that cannot tell where it is. */
    Scene mute() {
        return new Scene(name, rules, presses, own, raised, inOrder, false, times);
    }

    /** Every kind of adapter and device. */
    List<Scene> kinds() {
        return List.of(this, outOfOrder(), mute(), mute().outOfOrder());
    }

    @Override
    public String toString() {
        return name + (inOrder ? " in order" : " out of order") + (canLocate ? "" : ", mute") + " " + times;
    }
}

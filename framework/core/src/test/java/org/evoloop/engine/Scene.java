package org.evoloop.engine;

import static org.evoloop.Machines.machine;

import java.time.Duration;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.PaperModels;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * What is explored: a pair with its timers, and how often each external act may happen.
 *
 * @param next the rules after it has evolved, from which it also evolves back
 * @param mapping between the states of both
 * @param inOrder whether the adapter reports the effects of steps in order with what the device does by itself
 * @param canLocate whether the device can report its state
 */
record Scene(
        String name,
        Rules rules,
        Rules next,
        Mapping mapping,
        Set<Event> presses,
        Set<Event> own,
        Set<Event> raised,
        boolean inOrder,
        boolean canLocate,
        Map<Act, Integer> times) {

    /** What may happen from outside, a limited number of times. */
    enum Act {
        /** A controller's event. */
        PRESS,
        /** The device does something by itself that is in its model. */
        OWN,
        /** The device changes its state outside its model, and is found there. */
        JUMP,
        /** A report of what the device did by itself is lost, so that the record is wrong. */
        LOSE,
        /** A function or a late timer raises an event, possibly of the previous visit. */
        RAISE,
        /** A function asks for an event of the device. */
        ASK,
        /** The converter is closed, or opened again. */
        STOP,
        /** The models are replaced. */
        EVOLVE,
        /** Components are exchanged. */
        CHANGE,
        /** A component fails. */
        FAIL,
        /** A component is given up. */
        GIVE_UP,
        /** Analyze or plan dismisses an occurrence or refuses it by a rule of its own. */
        DISMISS,
        /** The process ends abruptly, and another one takes over the core. */
        END
    }

    static Scene robot() {
        return of("robot", PaperModels.cleaningRobot(), Map.of("SpotWait", "timeout"), "Clean Spot", "Clean Spot", 2);
    }

    static Scene bulb() {
        return of("bulb", PaperModels.lightBulb(), Map.of("wait", "timeout"), "switch", "switch", 2);
    }

    /** A machine that defers an event in a new state, and has effects where it leaves that. */
    static Scene grinder() {
        return of(
                "grinder",
                new ModelPair(
                        machine("grinder", "Off start -> On", "On stop -> Off", "On grind -> On"),
                        machine(
                                "cleaning grinder",
                                "Off start -> Cleaning",
                                "Cleaning stop -> Off / beep, blink",
                                "Cleaning timeout -> On / beep, blink",
                                "Cleaning defers grind",
                                "On stop -> Off",
                                "On grind -> On")),
                Map.of("Cleaning", "timeout"),
                "start stop grind",
                "stop",
                2);
    }

    /** A device that may slip again before the new model reacts to the first slip, for which it sends a step. */
    static Scene slipping() {
        return of(
                "slipping",
                new ModelPair(
                        machine("device", "A slip -> C", "C slip -> D", "C step -> B", "D step -> B", "B slip -> A"),
                        machine("new", "A slip -> B", "B slip -> W", "W back -> A")),
                Map.of(),
                "step",
                "slip",
                2);
    }

    /**
     * A lamp that remembers whether it was dimmed, and dims only in the dark. The new one glows before it goes out, and
     * comes back dimmed only in the dark; it would always dim, but the device may not let it. One event may wait.
     */
    static Scene lamp() {
        return of(
                "lamp",
                new ModelPair(
                        machine(
                                "lamp",
                                "Off power -> Bright",
                                "Off[Dim] power -> Dim",
                                "Bright power -> Off",
                                "Dim power -> Off[Dim]",
                                "Bright dim [dark] -> Dim",
                                "Dim dim -> Bright"),
                        machine(
                                "glowing lamp",
                                "Off power -> Bright",
                                "Off[Dim] power [dark] -> Dim",
                                "Off[Dim] power -> Bright",
                                "Bright power -> Glow",
                                "Dim power -> Glow[Dim]",
                                "Glow timeout -> Off",
                                "Glow[Dim] timeout -> Off[Dim]",
                                "Glow power -> Bright",
                                "Glow[Dim] power -> Dim",
                                "Glow dim [dark] -> Dim",
                                "Bright dim -> Dim",
                                "Dim dim -> Bright")),
                Map.of("Glow", "timeout", "Glow[Dim]", "timeout"),
                "power dim",
                "power dim",
                1);
    }

    /**
     * A scene in which nothing happens.
     *
     * @param timers the time event of each state that has one
     * @param sendable names separated by spaces
     * @param spontaneous likewise, the events that the device does by itself although they can be sent; what cannot be
     *     sent it does by itself, too
     */
    static Scene of(
            String name,
            ModelPair pair,
            Map<String, String> timers,
            String sendable,
            String spontaneous,
            int queueCapacity) {
        Set<Event> sent = events(sendable);
        Rules rules = rules(pair, timers, sendable, spontaneous, queueCapacity);
        Set<Event> own = rules.table().device().spontaneous();
        Set<Event> raised = pair.evolved().triggers().stream()
                .filter(event -> !pair.original().triggers().contains(event))
                .collect(Collectors.toSet());
        return new Scene(name, rules, rules, Mapping.byName(), sent, own, raised, true, true, Map.of());
    }

    /**
     * An elevator with express rides of two steps, which an alarm ends: the pair of {@code prism/proof/lift}. One event
     * may wait.
     */
    static Scene lift() {
        String[] lift = {"F up -> G", "G up -> H", "H down -> G", "G down -> F"};
        return of(
                        "lift",
                        new ModelPair(
                                machine("lift", lift),
                                machine(
                                        "lift with alarm",
                                        Stream.concat(
                                                        Stream.of(lift),
                                                        Stream.of(
                                                                "F express -> H",
                                                                "H express -> F",
                                                                "F fire -> Alarm",
                                                                "G fire -> Alarm",
                                                                "H fire -> Alarm",
                                                                "Alarm device F",
                                                                "Alarm timeout -> F",
                                                                "urgent fire"))
                                                .toArray(String[]::new))),
                        Map.of("Alarm", "timeout"),
                        "up down",
                        "down",
                        1)
                .pressing("express fire");
    }

    private static Rules rules(
            ModelPair pair, Map<String, String> timers, String sendable, String spontaneous, int queueCapacity) {
        Set<Event> sent = events(sendable);
        Set<Event> own = events(spontaneous);
        pair.original().triggers().stream()
                .filter(event -> !sent.contains(event))
                .forEach(own::add);
        DeviceEvents device =
                new DeviceEvents(sent, own).withBoundGuards(pair.original().guards());
        DecisionTable table = DecisionTable.compile(pair, device);
        return new Rules(table, state -> timersOf(timers, state), queueCapacity);
    }

    /** A device that slides twice before it can be brought back, and a new model with a function between. */
    static Scene sliding() {
        return of(
                "sliding",
                new ModelPair(
                        machine("device", "A first -> B", "B second -> C", "C go -> A", "A go -> A", "B go -> A"),
                        machine("new", "A first -> B", "B second -> W", "W back -> A", "A go -> A", "B go -> A")),
                Map.of(),
                "go",
                "first second",
                2);
    }

    /** The robot, whose next models add a dance and drop the detour by SpotWait. */
    static Scene dancingRobot() {
        return robot().evolvingTo(
                        "dancing",
                        "Clean Spot",
                        machine(
                                "dancing",
                                "Off Clean -> On",
                                "On Clean -> Clean",
                                "Clean Clean -> On",
                                "On Spot -> Move",
                                "Move arriveSpot -> Spot",
                                "Spot endSpot -> On",
                                "On timeout -> Dance",
                                "Dance Clean -> Clean",
                                "Dance timeout -> On"));
    }

    /** The robot, whose next models move while it cleans, so that it has to be sent there. */
    static Scene busyRobot() {
        return robot().evolvingTo(
                        "busy",
                        "",
                        machine(
                                "busy",
                                "Off Clean -> On",
                                "On Clean -> Clean",
                                "Clean Clean -> On",
                                "Clean Spot -> Move",
                                "Move arriveSpot -> On",
                                "Move timeout -> Clean",
                                "On Spot -> Spot",
                                "Spot endSpot -> On"));
    }

    /** The bulb, whose next new model is the original one: wherever the new light is on, the device knows nothing of it. */
    static Scene plainBulb() {
        StateMachine original = PaperModels.lightBulb().original();
        Scene plain = of("plain bulb", new ModelPair(original, original), Map.of(), "switch", "switch", 2);
        Mapping lights = Mapping.byName()
                .withState(new State("wait"), new State("on"))
                .withState(new State("incandescentOn"), new State("off"));
        return bulb().evolvingTo(plain, lights);
    }

    private Scene evolvingTo(String learnt, String spontaneous, StateMachine evolved) {
        ModelPair pair = new ModelPair(rules.table().models().original(), evolved);
        Map<String, String> timers = Map.of("SpotWait", "timeout", "Dance", "timeout", "Move", "timeout");
        Rules other = rules(pair, timers, "Clean Spot", spontaneous, 2);
        return new Scene(
                name + ", " + learnt, rules, other, Mapping.byName(), presses, own, raised, inOrder, canLocate, times);
    }

    /** The same scene, which may evolve to the pair of {@code other} and back. */
    Scene evolvingTo(Scene other, Mapping names) {
        String both = name + ", evolving to " + other.name;
        return new Scene(both, rules, other.rules, names, presses, own, raised, inOrder, canLocate, times);
    }

    /** The evolution to the other pair, or back. */
    Swap swap(boolean back) {
        return back ? Swap.of(next, rules, mapping.reversed()) : Swap.of(rules, next, mapping);
    }

    /** The same scene in which controllers press the events of the new model, too. */
    Scene pressing(String more) {
        Set<Event> all = new HashSet<>(presses);
        all.addAll(events(more));
        Set<Event> others = new HashSet<>(raised);
        others.removeAll(all);
        return new Scene(name, rules, next, mapping, all, own, others, inOrder, canLocate, times);
    }

    /** The same scene in which the functions of new states may send whatever can be sent. */
    Scene sending() {
        return new Scene(
                name + ", sending",
                sending(rules),
                sending(next),
                mapping,
                presses,
                own,
                raised,
                inOrder,
                canLocate,
                times);
    }

    private static Rules sending(Rules silent) {
        ModelPair pair = silent.table().models();
        DeviceEvents device = silent.table().device();
        StateMachine evolved = pair.evolved();
        for (State state : pair.evolved().states()) {
            for (Event event : pair.isNew(state) ? device.sendable() : Set.<Event>of()) {
                evolved = evolved.withSends(state, event);
            }
        }
        return silent.with(DecisionTable.compile(new ModelPair(pair.original(), evolved), device));
    }

    /** The same scene with this reaction to a failed step of a plan. */
    Scene onFailure(OnFailure then) {
        ModelPair pair = rules.table().models();
        Map<State, Map<String, OnFailure>> all = new HashMap<>();
        pair.evolved()
                .transitions()
                .forEach(transition -> all.computeIfAbsent(transition.source(), state -> new HashMap<>())
                        .put(transition.event().toString(), then));
        DecisionTable table = DecisionTable.compile(pair, rules.table().device().withOnFailure(all));
        Rules other = rules.with(table);
        return new Scene(name + ", " + then, other, other, mapping, presses, own, raised, inOrder, canLocate, times);
    }

    private static Map<Event, Duration> timersOf(Map<String, String> timers, State state) {
        String event = timers.get(state.name());
        return event == null ? Map.of() : Map.of(new Event(event), Duration.ofSeconds(5));
    }

    private static Set<Event> events(String names) {
        return Stream.of(names.split(" "))
                .filter(name -> !name.isEmpty())
                .map(Event::new)
                .collect(Collectors.toSet());
    }

    /** The same scene in which as many events of controllers may wait. */
    Scene withQueue(int capacity) {
        Rules other = new Rules(rules.table(), rules.timers(), capacity);
        String changed = name + ", queue of " + capacity;
        return new Scene(changed, other, other, mapping, presses, own, raised, inOrder, canLocate, times);
    }

    /** The same scene in which a press may be this old when its turn comes; each input takes a nanosecond. */
    Scene withPressAge(long nanos) {
        Rules other = new Rules(rules.table(), rules.timers(), rules.queueCapacity(), Duration.ofNanos(nanos));
        String changed = name + ", presses of " + nanos + " ns";
        return new Scene(changed, other, other, mapping, presses, own, raised, inOrder, canLocate, times);
    }

    /** The same scene in which {@code act} may happen at most this often. */
    Scene with(Act act, int most) {
        Map<Act, Integer> more = new EnumMap<>(Act.class);
        more.putAll(times);
        more.put(act, most);
        return new Scene(name, rules, next, mapping, presses, own, raised, inOrder, canLocate, more);
    }

    Scene with(int most, Act... acts) {
        Scene scene = this;
        for (Act act : acts) {
            scene = scene.with(act, most);
        }
        return scene;
    }

    /** The same scene with an adapter that reports an effect when {@code send} returns. */
    Scene outOfOrder() {
        return new Scene(name, rules, next, mapping, presses, own, raised, false, canLocate, times);
    }

    /** The same scene with a device that cannot report its state. */
    Scene mute() {
        return new Scene(name, rules, next, mapping, presses, own, raised, inOrder, false, times);
    }

    /** This scene with every kind of adapter and device. */
    List<Scene> kinds() {
        return List.of(this, outOfOrder(), mute(), mute().outOfOrder());
    }

    @Override
    public String toString() {
        return name + (inOrder ? " in order" : " out of order") + (canLocate ? "" : ", mute") + " " + times;
    }
}

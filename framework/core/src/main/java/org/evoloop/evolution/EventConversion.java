package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The paper's Algorithm 1 as a pure function of the pair, both current states and the occurrence.
 *
 * <p>Where the paper leaves a question open: the original model moves by the events actually sent (line 9 moves it by
 * the incoming event, which it may not know); an occurrence on which the device has already acted moves it first; and
 * an event that is declared to be the device's own and cannot be sent was taken by the device itself. An event with a
 * guard is the original's event with the same guard, else the original's event without one.
 *
 * <p>Threading: not thread-safe; its path planner caches its searches.
 */
final class EventConversion {
    private final ModelPair pair;
    private final DeviceEvents device;
    private final PathPlanner planner;
    private final Set<Event> unsendable;
    /** By the new model's states. */
    private final Map<State, Target> targets;

    /** Whether any new state needs the device somewhere: it is asked whenever an occurrence ends. */
    private final boolean needing;

    EventConversion(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.device = device;
        this.planner = new PathPlanner(pair.original(), device);
        this.unsendable = device.unsendable(pair.original());
        Set<State> states = pair.evolved().states();
        this.targets = new HashMap<>(2 * states.size());
        for (State state : states) {
            targets.put(state, Target.of(state, pair));
        }
        this.needing = targets.values().stream().anyMatch(Target::needsDevice);
    }

    /**
     * What a state of the new model means for the device.
     *
     * @param isNew whether only the new model has it
     * @param first the first of {@code goals}, and most often the only one, so that the list need not be examined; null
     *     if there is none
     * @param goals where the device must be; none if it may be anywhere
     * @param together the configuration once the device is in the first goal: most decisions end in it, and one shared
     *     object is looked up faster than equal ones; null if there is no goal
     */
    private record Target(
            State state,
            boolean isNew,
            @Nullable State first,
            List<State> goals,
            @Nullable Configuration together) {
        static Target of(State state, ModelPair pair) {
            List<State> goals = pair.whereDeviceMustBe(state);
            State first = goals.isEmpty() ? null : goals.get(0);
            return new Target(
                    state, pair.isNew(state), first, goals, first == null ? null : new Configuration(first, state));
        }

        boolean isAnywhere() {
            return first == null;
        }

        /** Whether it is a new state that needs the device somewhere. */
        boolean needsDevice() {
            return isNew && first != null;
        }

        boolean hasGoal(State original) {
            return original.equals(first) || goals.contains(original);
        }

        Configuration with(State original) {
            return together != null && original.equals(first) ? together : new Configuration(original, state);
        }
    }

    /** Whether only the new model has {@code state}. */
    boolean isNew(State state) {
        return target(state).isNew();
    }

    private Target target(State state) {
        Target known = targets.get(state);
        return known == null ? new Target(state, true, null, List.of(), null) : known;
    }

    /** See {@link DecisionTable#needsDevice}. */
    boolean needsDevice(State state) {
        return needing && target(state).needsDevice();
    }

    /** See {@link DecisionTable#isWhereNeeded}. */
    boolean isWhereNeeded(Configuration at) {
        if (!needing) {
            return true;
        }
        Target present = target(at.evolved());
        return !present.needsDevice() || present.hasGoal(at.original());
    }

    /**
     * Whether {@code trigger} is an event of the device that no component sends and that is not declared spontaneous.
     */
    boolean isUnsendable(Event trigger) {
        return unsendable.contains(trigger);
    }

    /** The decision for {@code event} in {@code before}. */
    Decision decide(Configuration before, Event event, boolean deviceActed) {
        return decide(
                before,
                event,
                deviceActed,
                pair.evolved().transition(before.evolved(), event).orElse(null),
                originalTransition(before.original(), event));
    }

    /**
     * As the other method, with both transitions already looked up.
     *
     * @param transition the new model's transition on the event
     * @param same see {@link #originalTransition}
     */
    Decision decide(
            Configuration before,
            Event event,
            boolean deviceActed,
            @Nullable Transition transition,
            @Nullable Transition same) {
        boolean taken = deviceActed || device.isOwn(event.trigger());
        Transition own = taken ? same : null;
        List<Step> steps = own == null ? List.of() : List.of(new Step(own, true, false));
        State original = own == null ? before.original() : own.target();

        if (transition == null) {
            Configuration after = before.withOriginal(original);
            return steps.isEmpty() || isWhereNeeded(after)
                    ? new Decision.NotAcceptable(before, after, steps)
                    : new Decision.Resynchronization(before, followed(original), steps);
        }
        if (!taken && isUnsendable(event.trigger())) {
            return new Decision.Impossible(
                    before,
                    before,
                    List.of(),
                    transition,
                    "event " + event.trigger()
                            + " is the device's, but can neither be sent nor is it declared to be the device's own");
        }
        Target target = target(transition.target());
        if (target.isAnywhere()) {
            return new Decision.NewState(
                    before, target.with(original), steps, transition, effectsLeft(transition, steps));
        }
        Optional<List<Step>> way =
                taken ? planner.shortestPath(original, target.goals()) : wayFor(original, same, target);
        if (way.isEmpty()) {
            return new Decision.Impossible(
                    before, before.withOriginal(original), steps, transition, noWay(wanted(event, target), original));
        }
        return reaching(before, steps, steps, way.get(), transition, target);
    }

    /** The device has left the device state, and the new model has no transition for that: it follows. */
    private Configuration followed(State original) {
        return new Configuration(original, pair.evolvedStates(original).get(0));
    }

    private static String wanted(Event event, Target target) {
        String leads = "event " + event + " leads to " + target.state();
        return target.isNew() ? leads + ", where the device must be in " + where(target) : leads;
    }

    private static String where(Target target) {
        return String.join(" or ", target.goals().stream().map(State::name).toList());
    }

    /**
     * @param steps the device's own steps of this decision, which precede the path
     * @param done all steps that the device took on the event by itself, whose effects need not be run
     */
    private static Decision reaching(
            Configuration before,
            List<Step> steps,
            List<Step> done,
            List<Step> way,
            Transition transition,
            Target target) {
        List<Step> all = joined(steps, way);
        State reached =
                all.isEmpty() ? before.original() : all.get(all.size() - 1).target();
        List<String> effects = effectsLeft(transition, joined(done, way));
        return target.isNew()
                ? new Decision.NewState(before, target.with(reached), all, transition, effects)
                : new Decision.ExistingState(before, target.with(reached), all, transition, effects);
    }

    /** See {@link DecisionTable#react}. */
    Decision react(Configuration at, Event event, @Nullable Step own, boolean follow) {
        Transition transition = pair.evolved().transition(at.evolved(), event).orElse(null);
        if (transition == null) {
            return new Decision.NotAcceptable(at, at, List.of());
        }
        Target target = target(transition.target());
        List<Step> done = own == null ? List.of() : List.of(own);
        if (target.isAnywhere()) {
            return new Decision.NewState(
                    at, target.with(at.original()), List.of(), transition, effectsLeft(transition, done));
        }
        if (follow && own != null && target.hasGoal(own.target())) {
            return reaching(at, List.of(), done, List.of(), transition, target);
        }
        List<Step> way = planner.shortestPath(at.original(), target.goals()).orElse(null);
        return way == null
                ? new Decision.Impossible(at, at, List.of(), transition, noWay(wanted(event, target), at.original()))
                : reaching(at, List.of(), done, way, transition, target);
    }

    /**
     * The new model's function asks for {@code trigger}. What its state does not declare is not sent, so that what was
     * checked of the model holds.
     *
     * @param taken the transition that the device takes on it now; null if its model has none
     */
    Decision send(Configuration at, Event trigger, @Nullable Transition taken, boolean conditional) {
        State asking = pair.evolved().withoutMemory(at.evolved());
        if (!device.sendable().contains(trigger)) {
            return notSent(at, trigger, asking, ", but no execute component can send it");
        }
        if (!pair.evolved().sends(at.evolved()).contains(trigger)) {
            String call = "sends(\"" + asking + "\", \"" + trigger + "\")";
            return notSent(
                    at,
                    trigger,
                    asking,
                    ", which " + asking + " does not declare; draw \"sends " + trigger + "\" in " + asking
                            + " (SCXML: ev:sends=\"" + trigger + "\"), or call " + call + " in registerNewFunctions");
        }
        if (taken == null) {
            return notSent(at, trigger, asking, ", but the device has no transition for it in " + at.original());
        }
        Configuration after = at.withOriginal(taken.target());
        return isWhereNeeded(after)
                ? new Decision.Sending(at, after, List.of(new Step(taken, false, conditional)))
                : notSent(
                        at,
                        trigger,
                        asking,
                        ", but it takes the device to " + taken.target() + ", and " + asking + " needs it in "
                                + where(target(at.evolved())) + "; draw another new state for that");
    }

    private static Decision notSent(Configuration at, Event trigger, State asking, String why) {
        return new Decision.Impossible(
                at, at, List.of(), null, "the function of " + asking + " asks for " + trigger + why);
    }

    /** See {@link DecisionTable#prefer}. */
    Decision prefer(Decision usual, Map<Event, Integer> costs) {
        Transition transition = usual.transition();
        boolean leads = usual instanceof Decision.ExistingState || usual instanceof Decision.NewState;
        List<Step> own = usual.steps().stream().filter(Step::byDevice).toList();
        List<Step> sent = usual.steps().subList(own.size(), usual.steps().size());
        if (transition == null || !leads || sent.isEmpty() || isDirect(sent, transition)) {
            return usual;
        }
        Target target = target(transition.target());
        return new PathPlanner(pair.original(), device.withCosts(costs))
                .shortestPath(usual.deviceStart(), target.goals())
                .filter(way -> !way.equals(sent))
                .map(way -> reaching(usual.before(), own, own, way, transition, target))
                .orElse(usual);
    }

    private static boolean isDirect(List<Step> sent, Transition transition) {
        return sent.size() == 1
                && sent.get(0).trigger().equals(transition.event().trigger());
    }

    /** See {@link DecisionTable#settle}. */
    Decision settle(Configuration at, List<State> goals) {
        List<Step> way = planner.shortestPath(at.original(), goals).orElse(null);
        if (way == null) {
            String stands = "the new model is in " + at.evolved();
            return new Decision.Impossible(at, at, List.of(), null, noWay(stands, at.original()));
        }
        State reached = way.isEmpty() ? at.original() : way.get(way.size() - 1).target();
        return new Decision.Sending(at, at.withOriginal(reached), way);
    }

    /** See {@link DecisionTable#afterFailure}. */
    Decision afterFailure(Decision usual, Configuration at, BrokenPlan broken) {
        PathPlanner others = new PathPlanner(pair.original(), device, broken.failed());
        if (broken.then() == OnFailure.GO_BACK) {
            return goBack(at, broken, others);
        }
        Transition transition = usual.transition();
        if (transition == null || broken.failed().stream().noneMatch(usual.steps()::contains)) {
            return usual;
        }
        List<Step> own = usual.steps().stream().filter(Step::byDevice).toList();
        Target target = target(transition.target());
        List<Step> way =
                others.shortestPath(usual.deviceStart(), target.goals()).orElse(null);
        return way == null
                ? new Decision.Impossible(
                        usual.before(),
                        usual.start(),
                        own,
                        transition,
                        broken.reason() + "; no other way leads from " + usual.deviceStart() + " to " + target.state())
                : reaching(usual.before(), own, own, way, transition, target);
    }

    /** Whether or not the device gets back, the event has failed. */
    private static Decision goBack(Configuration at, BrokenPlan broken, PathPlanner planner) {
        List<Step> way =
                planner.shortestPath(at.original(), List.of(broken.begun())).orElse(null);
        return way == null
                ? new Decision.Impossible(
                        at,
                        at,
                        List.of(),
                        null,
                        broken.reason() + "; no events that can be sent lead back from " + at.original() + " to "
                                + broken.begun())
                : new Decision.Impossible(
                        at,
                        at.withOriginal(broken.begun()),
                        way,
                        null,
                        broken.reason() + "; the device goes back to " + broken.begun());
    }

    private static List<Step> joined(List<Step> first, List<Step> then) {
        if (first.isEmpty() || then.isEmpty()) {
            return first.isEmpty() ? then : first;
        }
        List<Step> all = new ArrayList<>(first);
        all.addAll(then);
        return List.copyOf(all);
    }

    /**
     * The original's transition on the same guarded event, else on the event without guards; null if it has neither.
     */
    @Nullable
    Transition originalTransition(State source, Event event) {
        StateMachine original = pair.original();
        Transition guarded = original.transition(source, event).orElse(null);
        return guarded != null
                ? guarded
                : original.transition(source, event.trigger()).orElse(null);
    }

    /**
     * The incoming event itself if it leads to one of the goals, even from a state to itself; else the shortest
     * path.
     */
    private Optional<List<Step>> wayFor(State original, @Nullable Transition same, Target target) {
        Step direct = same == null || !target.hasGoal(same.target()) ? null : planner.stepOver(same);
        return direct == null ? planner.shortestPath(original, target.goals()) : Optional.of(List.of(direct));
    }

    /** The effects of the new model's transition that the device does not run by itself in {@code steps}. */
    private static List<String> effectsLeft(Transition transition, List<Step> steps) {
        if (transition.effects().isEmpty()) {
            return List.of();
        }
        List<String> left = new ArrayList<>(transition.effects());
        for (Step step : steps) {
            for (String effect : step.effects()) {
                left.remove(effect);
            }
        }
        return List.copyOf(left);
    }

    private String noWay(String wanted, State original) {
        StringBuilder reason = new StringBuilder(wanted + ", but with the device in " + original
                + " no events that can be sent take it there (sendable: " + names(device.sendable()));
        if (!device.doNotPass().isEmpty()) {
            reason.append("; not to be passed: ").append(names(device.doNotPass()));
        }
        Set<String> unbound = new HashSet<>(pair.original().guards());
        unbound.removeAll(device.boundGuards());
        if (!unbound.isEmpty()) {
            reason.append("; guards that cannot be asked: ").append(names(unbound));
        }
        return reason.append(')').toString();
    }

    private static String names(Set<?> members) {
        Set<String> names = new TreeSet<>();
        for (Object member : members) {
            names.add(member.toString());
        }
        return names.isEmpty() ? "none" : String.join(", ", names);
    }
}

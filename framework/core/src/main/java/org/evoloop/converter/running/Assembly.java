package org.evoloop.converter.running;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.KnowledgeAccess;
import org.evoloop.converter.binding.Bindings;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.Component;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.Names;

/**
 * The components of a converter by name, and the decisions that they can carry out.
 *
 * <p>Threading: guarded by its converter.
 */
public final class Assembly {
    private final Map<String, Component> components = new LinkedHashMap<>();

    public void add(Component component) {
        if (components.putIfAbsent(component.name(), component) != null) {
            throw new IllegalStateException(
                    "there is a component named " + component.name() + " already; give one of them another name");
        }
    }

    /** A copy with {@code added} at its end. */
    public Assembly with(Component added) {
        Assembly changed = copy();
        changed.add(added);
        return changed;
    }

    /** A copy in which {@code next} replaces the component {@code name}. */
    public Assembly with(String name, Component next) {
        Assembly changed = new Assembly();
        for (Component component : all()) {
            changed.add(component.name().equals(name) ? next : component);
        }
        return changed;
    }

    /** The component {@code name}, which must exist. */
    public Component require(String name) {
        return Objects.requireNonNull(components.get(name));
    }

    /** A copy without the component {@code name}. */
    public Assembly without(String name) {
        Assembly changed = copy();
        changed.components.remove(name);
        return changed;
    }

    private Assembly copy() {
        Assembly copy = new Assembly();
        copy.components.putAll(components);
        return copy;
    }

    public Collection<Component> all() {
        return components.values();
    }

    public List<EventExecute> executes() {
        return all(EventExecute.class);
    }

    public List<EventMonitor> monitors() {
        return all(EventMonitor.class);
    }

    private <T extends Component> List<T> all(Class<T> kind) {
        return all().stream().filter(kind::isInstance).map(kind::cast).toList();
    }

    /** The events that controllers raise, as the monitors say. */
    Set<Event> reportedOfControllers() {
        return monitors().stream()
                .flatMap(monitor -> Friends.MONITOR.of(monitor).controllerEvents().stream())
                .collect(Collectors.toUnmodifiableSet());
    }

    public boolean has(Component.Role role) {
        for (Component component : all()) {
            if (component.role() == role) {
                return true;
            }
        }
        return false;
    }

    /**
     * As {@link #decisions}, but first checks what was registered with {@code knowledge}.
     *
     * @param leftOver see {@link KnowledgeAccess#problems}
     * @throws ModelException if something does not fit; the message lists all problems
     */
    public DecisionTable compile(StateKnowledge knowledge, boolean leftOver) {
        KnowledgeAccess access = Friends.KNOWLEDGE.of(knowledge);
        access.register();
        List<String> problems = new ArrayList<>(access.problems(leftOver));
        DecisionTable table = null;
        try {
            table = decisions(knowledge);
        } catch (ModelException undecidable) {
            problems.add(undecidable.getMessage());
        }
        if (table == null || !problems.isEmpty()) {
            throw new ModelException(String.join("\n", problems));
        }
        return table;
    }

    /**
     * The decisions that these components can carry out.
     *
     * @throws ModelException if they cannot carry out some decision, or send events that the device does not have
     */
    public DecisionTable decisions(StateKnowledge knowledge) {
        ModelPair pair = knowledge.models();
        List<String> problems = new ArrayList<>();
        Map<Event, EventExecute> senders = new LinkedHashMap<>();
        for (EventExecute execute : executes()) {
            Set<Event> events = Friends.EXECUTE.of(execute).events();
            requireOriginal(pair, execute.name() + " can send", events, problems);
            for (Event event : events) {
                EventExecute other = senders.putIfAbsent(event, execute);
                if (other != null) {
                    problems.add(other.name() + " and " + execute.name() + " can both send " + event
                            + "; let one of them do it");
                }
            }
        }
        Set<Event> spontaneous = new HashSet<>();
        for (EventMonitor monitor : monitors()) {
            Set<Event> events = Friends.MONITOR.of(monitor).spontaneousEvents();
            spontaneous.addAll(events);
            requireOriginal(pair, monitor.name() + " names as the device's own", events, problems);
        }
        DeviceEvents device = new DeviceEvents(senders.keySet(), spontaneous);
        for (Event event : device.unsendable(pair.original())) {
            problems.add(
                    "event " + event + " of the original model can be sent by no execute component and is not declared"
                            + " to be the device's own; name it in sendableEvents, or in spontaneousEvents of a monitor");
        }
        Bindings bindings = Friends.KNOWLEDGE.of(knowledge).bindings();
        DecisionTable table = DecisionTable.compile(pair, bindings.refine(device));
        for (Decision.Impossible impossible : table.problems()) {
            problems.add("no plan in " + impossible.before() + ": " + impossible.reason());
        }
        problems.addAll(bindings.unboundEffects(table));
        if (!problems.isEmpty()) {
            throw new ModelException("the model '" + pair.evolved().name() + "' cannot be carried out:\n  "
                    + String.join("\n  ", problems));
        }
        return table;
    }

    private static void requireOriginal(ModelPair pair, String who, Set<Event> events, List<String> problems) {
        Set<Event> triggers = pair.original().triggers();
        for (Event event : events) {
            if (!triggers.contains(event)) {
                problems.add(who + " " + event + ", which is not an event of the original model '"
                        + pair.original().name() + "'" + Names.hint(event.name(), triggers));
            }
        }
    }
}

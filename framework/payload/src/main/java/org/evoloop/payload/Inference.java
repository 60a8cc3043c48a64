package org.evoloop.payload;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * Finds the event behind a changed state, for a device that reports its state but not what it does: a washing machine whose
 * power has dropped has ended its program.
 *
 * <p>Threading: thread-safe if the supplier is.
 *
 * @since 0.1
 */
public final class Inference {
    private final SystemEventConverter converter;
    private final Supplier<Set<String>> more;

    /**
     * About the device of {@code converter}.
     *
     * @param more events that the device takes by itself, such as those of its own buttons, beside those that its model
     *     declares to be its own
     */
    public Inference(SystemEventConverter converter, Supplier<Set<String>> more) {
        this.converter = converter;
        this.more = more;
    }

    /**
     * The event that the device has taken by itself if it is now in {@code state}: the only one that leads there from
     * where the converter believes it to be. Empty if there are several or none, if the record is in doubt, or if an
     * event is being handled, whose own steps may have led there.
     */
    public Optional<String> eventTo(String state) {
        ConverterStatus status = converter.status();
        if (!status.doubt().isEmpty() || status.events().inProgress() > 0) {
            return Optional.empty();
        }
        StateMachine original = converter.knowledge().models().original();
        Set<Event> own = new LinkedHashSet<>(
                new DeviceEvents(Set.of(), Set.of()).declaredBy(original).spontaneous());
        more.get().forEach(name -> own.add(new Event(name)));
        State to = new State(state);
        List<String> ways = original.transitionsFrom(status.states().original()).stream()
                .filter(transition -> transition.target().equals(to))
                .map(transition -> transition.event().trigger())
                .filter(own::contains)
                .map(Event::name)
                .distinct()
                .toList();
        return ways.size() == 1 ? Optional.of(ways.get(0)) : Optional.empty();
    }
}

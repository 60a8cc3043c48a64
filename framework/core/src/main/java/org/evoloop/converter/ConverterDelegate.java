package org.evoloop.converter;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Sentry;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.time.Clock;

/**
 * What a {@link SystemEventConverter} hands its calls to; its methods are described there. The implementation uses the
 * components of this package, so this package must not name it: it is a service, which the package {@code changing}
 * provides. Not for users.
 *
 * @since 0.1
 */
public interface ConverterDelegate {
    /** Makes delegates. */
    interface Maker {
        ConverterDelegate make(LoopConfig config);
    }

    void addKnowledge(StateKnowledge stateKnowledge);

    void addKnowledgeFactory(Function<ModelPair, ? extends StateKnowledge> factory);

    StateKnowledge knowledgeOf(ModelPair models);

    void addListener(ConverterListener listener);

    void removeListener(ConverterListener listener);

    void journal(ConverterJournal kept);

    void watch(Sentry.Posting sentries);

    void addLink(DeviceLink deviceLink);

    void addSpare(String name, Supplier<? extends Component> spare);

    void add(Component component);

    void build();

    void start();

    boolean stop();

    void remove(String name);

    void exchange(String name, Component next);

    void exchange(String name, String spare);

    Set<String> spares();

    Set<String> spares(Component.Role role);

    Evolution.Result evolve(Evolution evolution);

    Evolution.Result rollBack(Duration deadline);

    Shadow shadow(Evolution evolution);

    Optional<Shadow> shadow();

    boolean offer(Occurrence occurrence);

    void observe(EventMonitor monitor) throws InterruptedException;

    boolean step();

    Clock clock();

    boolean hasThreads();

    StateKnowledge knowledge();

    Set<Event> sendableEvents();

    Set<Event> controllerEvents();

    ConverterStatus status();

    Outlook outlook();

    List<HistoryEntry> history();

    List<HistoryEntry> history(int count);

    void close();
}

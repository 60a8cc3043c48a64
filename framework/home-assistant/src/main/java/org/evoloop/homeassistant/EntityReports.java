package org.evoloop.homeassistant;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.evoloop.payload.report.Report;
import org.evoloop.payload.report.Turns;

/**
 * The reports of one value: it is reported when it changes, and when the entity is there again.
 *
 * <p>Threading: called by one thread at a time, those that add consumers before the connection is opened.
 */
final class EntityReports implements HomeEntities.Listener {
    private final EntityValue what;
    private final Turns turns;
    private final List<Consumer<Report>> confirming = new CopyOnWriteArrayList<>();
    private final List<Consumer<Report>> events = new CopyOnWriteArrayList<>();
    private final List<Consumer<Report>> states = new CopyOnWriteArrayList<>();
    private String last = "";
    private Optional<String> value = Optional.empty();

    EntityReports(EntityValue what, Turns turns) {
        this.what = what;
        this.turns = turns;
    }

    /** Hears each report before the others, so that a step is over before its result is found. */
    void addConfirming(Consumer<Report> consumer) {
        confirming.add(consumer);
    }

    void addEvent(Consumer<Report> consumer) {
        events.add(consumer);
    }

    void addState(Consumer<Report> consumer) {
        states.add(consumer);
    }

    @Override
    public synchronized void hear(Entity now, boolean old) {
        Optional<String> said = now.state().equals("unknown") ? Optional.empty() : what.of(now);
        boolean isNews =
                old || !said.equals(value) || (now.isOfEvents() && !now.state().equals(last));
        value = said;
        last = now.state();
        if (isNews) {
            tell(old, List.of(confirming, events, states));
        }
    }

    private void tell(boolean old, List<List<Consumer<Report>>> consumers) {
        value.map(text -> new Report(text, old))
                .ifPresent(report ->
                        turns.take(() -> consumers.forEach(some -> some.forEach(each -> each.accept(report)))));
    }

    /** Tells those that wait for a confirmation what it is now. */
    synchronized void confirm() {
        tell(false, List.of(confirming));
    }

    /** Tells what it is now as an answer; it is no event. */
    synchronized void answer() {
        tell(false, List.of(confirming, states));
    }

    @Override
    public synchronized void lost(String why) {
        value = Optional.empty();
    }
}

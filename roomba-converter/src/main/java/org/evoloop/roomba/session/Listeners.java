package org.evoloop.roomba.session;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.inference.SpotWatch;

/**
 * Passes what it hears on to all who listen, in the order in which they came.
 *
 * <p>Threading: thread-safe.
 */
final class Listeners implements SessionListener {
    private final List<SessionListener> all = new CopyOnWriteArrayList<>();

    void add(SessionListener listener) {
        all.add(listener);
    }

    void remove(SessionListener listener) {
        all.remove(listener);
    }

    @Override
    public void received(Telemetry telemetry) {
        all.forEach(listener -> listener.received(telemetry));
    }

    @Override
    public void pressed(Button button, boolean robotActs) {
        all.forEach(listener -> listener.pressed(button, robotActs));
    }

    @Override
    public void spotEnded(SpotWatch.Ending how) {
        all.forEach(listener -> listener.spotEnded(how));
    }

    @Override
    public void seen(Activity activity) {
        all.forEach(listener -> listener.seen(activity));
    }
}

package org.evoloop.roomba;

import java.util.Set;
import org.evoloop.converter.PushMonitor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Monitors the robot: its CLEAN and SPOT buttons, and the end of a spot cleaning. The OI mode tells whether the robot acts
 * on a button by itself or merely reports it.
 */
final class MonitorEvent extends PushMonitor implements SessionListener {
    private static final Logger LOG = LoggerFactory.getLogger(MonitorEvent.class);

    MonitorEvent(RoombaSession session) {
        session.addListener(this);
    }

    @Override
    public void pressed(Button button, boolean robotActs) {
        if (button == Button.CLEAN) {
            push(fromPanel(RobotEvents.CLEAN, robotActs));
        } else if (button == Button.SPOT) {
            push(fromPanel(RobotEvents.SPOT, robotActs));
        }
    }

    @Override
    public void spotEnded(SpotWatch.Ending how) {
        LOG.debug("spot cleaning has ended: {}", how);
        push(fromDevice(RobotEvents.END_SPOT));
    }

    @Override
    public void seen(Activity activity) {
        push(foundIn(
                switch (activity) {
                    case ON -> RobotEvents.STATE_ON;
                    case CLEAN -> RobotEvents.STATE_CLEAN;
                    case SPOT -> RobotEvents.STATE_SPOT;
                }));
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return Set.of(RobotEvents.CLEAN, RobotEvents.SPOT, RobotEvents.END_SPOT);
    }
}

package org.evoloop.models.diagram;

import java.util.List;

/**
 * What to draw of events in time.
 *
 * <p>Threading: immutable.
 *
 * @param title the heading above it
 * @param lifelines the names of the lanes: a device, a model, or what is sent, from top to bottom
 * @param moments in order of time
 */
public record Timing(String title, List<String> lifelines, List<Moment> moments) {
    public Timing {
        lifelines = List.copyOf(lifelines);
        moments = List.copyOf(moments);
    }

    /**
     * One event.
     *
     * @param time as shown
     * @param what the event
     * @param states of each lifeline from then on; empty for none
     */
    public record Moment(String time, String what, List<String> states) {
        public Moment {
            states = List.copyOf(states);
        }
    }
}

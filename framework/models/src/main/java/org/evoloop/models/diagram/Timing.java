package org.evoloop.models.diagram;

import java.util.List;

/**
 * What is to be drawn of something that happens in time.
 *
 * <p>Threading: immutable.
 *
 * @param title stands above it
 * @param lifelines what has states, one below the other
 * @param moments what happens, in order of time
 */
public record Timing(String title, List<String> lifelines, List<Moment> moments) {
    public Timing {
        lifelines = List.copyOf(lifelines);
        moments = List.copyOf(moments);
    }

    /**
     * Something happens.
     *
     * @param time as it is shown
     * @param what the event
     * @param states of each lifeline from then on; empty for none
     */
    public record Moment(String time, String what, List<String> states) {
        public Moment {
            states = List.copyOf(states);
        }
    }
}

package org.evoloop.xmi.dialect;

import java.util.List;
import java.util.Optional;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Problem;
import org.evoloop.statechart.Vertex.ChartState;

/** Reads what a state has to do with the device where it does not stand in the state's name: {@code device StopUp}. */
public final class DeviceTexts {
    private DeviceTexts() {}

    /**
     * The state with what these texts say, besides its keywords. A text about something else is passed over, a misspelt
     * one reported.
     *
     * @param label of the state, for messages
     */
    public static ChartState read(ChartState drawn, String label, List<String> texts, Problems problems) {
        // Without the id, which the label has.
        Place place = new Place(drawn.place().file(), "", drawn.place().line());
        DeviceUse all = drawn.use();
        for (String text : texts) {
            Optional<DeviceUse> use = DeviceUse.parse(text);
            Optional<DeviceUse> both = use.flatMap(all::and);
            Problem wrong = use.isPresent() ? null : DeviceUse.misspelt(place, "state " + label, text);
            if (wrong != null) {
                problems.add(place, wrong.text());
            } else if (use.isPresent() && both.isEmpty()) {
                problems.add(
                        place,
                        "state " + label + " has two device states, " + all.device() + " and "
                                + use.get().device() + "; keep one");
            }
            all = both.orElse(all);
        }
        return all.equals(drawn.use()) ? drawn : drawn.with(all);
    }
}

package org.evoloop.testkit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Assigns incidents to commands.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface IncidentPlan {

    /**
     * The incidents of a command; called once for each, in order.
     *
     * @param number the number of the command at its device, from 1
     * @param event the event of the command
     */
    List<Incident> of(int number, String event);

    /** No incidents. */
    static IncidentPlan none() {
        return (number, event) -> List.of();
    }

    /** These incidents for the command of this number, from 1; none for the others. */
    static IncidentPlan at(int number, Incident... incidents) {
        if (number < 1) {
            throw new IllegalArgumentException("commands are counted from 1, and this is number " + number);
        }
        List<Incident> there = List.of(incidents);
        return (command, event) -> command == number ? there : List.of();
    }

    /**
     * For each command, with this probability, one of {@code incidents}, all equally likely; the same seed gives the
     * same incidents.
     *
     * @param probability 0 to 1
     */
    static IncidentPlan random(long seed, double probability, Incident... incidents) {
        if (!(probability >= 0 && probability <= 1) || incidents.length == 0) {
            throw new IllegalArgumentException("the probability is " + probability
                    + ", allowed is 0 to 1, and there are " + incidents.length + " incidents, needed is one");
        }
        Incident[] some = Arrays.copyOf(incidents, incidents.length);
        Random random = new Random(seed);
        return new IncidentPlan() {
            @Override
            public List<Incident> of(int number, String event) {
                return random.nextDouble() < probability ? List.of(some[random.nextInt(some.length)]) : List.of();
            }

            @Override
            public String toString() {
                return "incidents of seed " + seed;
            }
        };
    }

    /** The incidents of this plan, followed by those of {@code other}. */
    default IncidentPlan and(IncidentPlan other) {
        return (number, event) -> {
            List<Incident> all = new ArrayList<>(of(number, event));
            all.addAll(other.of(number, event));
            return all;
        };
    }
}

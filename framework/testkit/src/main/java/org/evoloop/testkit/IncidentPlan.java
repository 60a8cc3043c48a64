package org.evoloop.testkit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * Which command meets with what.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface IncidentPlan {

    /**
     * What befalls a command; called once for each, in order.
     *
     * @param number counts the commands of a device, from 1
     * @param event what is commanded
     */
    List<Incident> of(int number, String event);

    /** Nothing ever happens. */
    static IncidentPlan none() {
        return (number, event) -> List.of();
    }

    /** The command of this number, from 1, meets with these; the others with nothing. */
    static IncidentPlan at(int number, Incident... incidents) {
        if (number < 1) {
            throw new IllegalArgumentException("commands are counted from 1, and this is number " + number);
        }
        List<Incident> there = List.of(incidents);
        return (command, event) -> command == number ? there : List.of();
    }

    /**
     * Each command meets with one of {@code incidents}, all as likely, with this probability; the same seed gives the
     * same.
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

    /** What this says, and after it what {@code other} says. */
    default IncidentPlan and(IncidentPlan other) {
        return (number, event) -> {
            List<Incident> all = new ArrayList<>(of(number, event));
            all.addAll(other.of(number, event));
            return all;
        };
    }
}

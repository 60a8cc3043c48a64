package org.evoloop.models.temporal;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.evoloop.check.Check;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.timing.TimeCheck;
import org.evoloop.check.timing.TimeReport;

/**
 * All that can be found in a pair of models: by the rules, by the properties, and about time.
 *
 * <p>Threading: immutable.
 *
 * @param findings in the order of the rules, including those that are switched off
 * @param written the properties; none without a valid pair, since there are no events to analyse then
 */
public record PairCheck(List<Finding> findings, PropertyFile written, TimeReport times) {

    /**
     * Reads the properties of a valid pair.
     *
     * @param <E> what reading may throw
     */
    public interface Properties<E extends Exception> {
        /** Reads them. */
        PropertyFile read() throws E;
    }

    /** Checks a pair. */
    public static <E extends Exception> PairCheck run(CheckInput input, Properties<E> properties) throws E {
        List<Finding> all = new ArrayList<>(Check.run(input));
        if (all.stream().anyMatch(PairCheck::isNoEvolution)) {
            return new PairCheck(all, PropertyFile.none(), TimeReport.NONE);
        }
        PropertyFile written = properties.read();
        all.addAll(PropertyCheck.run(input, written));
        TimeReport times = TimeCheck.run(input, written.time(), written.file());
        all.addAll(times.findings());
        all.sort(Comparator.comparing(Finding::rule));
        return new PairCheck(all, written, times);
    }

    private static boolean isNoEvolution(Finding finding) {
        return switch (finding.rule()) {
            case CONDITION_1, CONDITION_2, INITIAL_DIFFERS, DEVICE_STATE -> true;
            default -> false;
        };
    }
}

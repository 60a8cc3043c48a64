package org.evoloop.check.timing;

/**
 * Whether a time property holds for everything that can happen, and by what margin.
 *
 * <p>Threading: immutable.
 *
 * @param best the shortest time that it ever takes, in nanoseconds; for a count, the lowest number; -1 if it never
 *     occurs
 * @param worst the longest time or highest number; -1 if it never occurs; {@link Span#FOR_EVER} if no bound was found
 * @param moments how many moments were explored
 * @param worstIfNothingUrgent as {@code worst}, if no event were urgent; the same where that makes no difference
 * @since 0.1
 */
public record TimeVerdict(
        TimeProperty property, boolean holds, long best, long worst, long moments, long worstIfNothingUrgent) {
    TimeVerdict(TimeProperty property, boolean holds, long best, long worst, long moments) {
        this(property, holds, best, worst, moments, worst);
    }

    /** A copy that says what it would be if no event were urgent. */
    TimeVerdict beside(TimeVerdict nothingUrgent) {
        return new TimeVerdict(property, holds, best, worst, moments, nothingUrgent.worst);
    }

    /** For people: {@code 'It answers' holds: after 0 s at best and 2.8 s at worst}. */
    @Override
    public String toString() {
        return "'" + property.name() + "' " + (holds ? "holds" : "does not hold") + ": " + figures();
    }

    private String figures() {
        if (best < 0 && worst < 0) {
            return "that never happens";
        } else if (property.form() instanceof TimeForm.Count) {
            return worst + " at worst";
        } else if (property.form() instanceof TimeForm.Before) {
            return "after " + Span.length(best) + " at worst";
        } else if (property.form() instanceof TimeForm.Stay stay && stay.span().maxNanos() == Span.FOR_EVER) {
            return Span.length(best) + " at worst";
        }
        return (best < 0 ? "never" : Span.length(best)) + " at best, " + longest(worst) + " at worst"
                + (worstIfNothingUrgent == worst
                        ? ""
                        : "; " + longest(worstIfNothingUrgent) + " if nothing were urgent");
    }

    private static String longest(long nanos) {
        return nanos == Span.FOR_EVER ? "without a bound" : Span.length(nanos);
    }
}

package org.evoloop.models.checking;

import org.evoloop.check.Element;

/** The drawings of both machines of a pair. */
public record Drawings(Drawing original, Drawing evolved) {
    private Drawing of(Element element) {
        return element.side() == Element.ModelRole.ORIGINAL ? original : evolved;
    }

    /** {@code robot.xml, line 12, id ek-39}, or only the file. */
    public String place(Element element) {
        return of(element).place(element);
    }

    /** Whether {@code element} was found in its drawing. */
    public boolean show(Element element) {
        return of(element).shows(element);
    }
}

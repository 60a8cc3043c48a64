package org.evoloop.xmi.dialect;

import java.util.List;
import org.evoloop.statemachine.ModelException;

/** One tool's format of state machines. {@code toString} describes the files that it reads and how to create one. */
public interface XmiDialect {

    /** Whether a document with this beginning has this dialect. */
    boolean recognises(XmiHead head);

    /**
     * Every machine of the document, in order, unchecked.
     *
     * @param head the part that {@link XmiHead#read} has consumed
     * @param stream positioned as {@link XmiHead#read} leaves it
     * @throws ModelException if the document as a whole cannot be read, see {@link XmiStream#refuse}
     */
    List<DrawnMachine> read(XmiHead head, XmiStream stream);
}

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import net.sourceforge.plantuml.BlockUml;
import net.sourceforge.plantuml.SourceStringReader;
import net.sourceforge.plantuml.abel.Entity;
import net.sourceforge.plantuml.abel.GroupType;
import net.sourceforge.plantuml.abel.LeafType;
import net.sourceforge.plantuml.abel.Link;
import net.sourceforge.plantuml.core.Diagram;
import net.sourceforge.plantuml.klimt.creole.Display;
import net.sourceforge.plantuml.statediagram.StateDiagram;

/**
 * Tells how PlantUML itself understands state diagrams: the file has several, each before a line ====. For each of them,
 * in order, prints a line for each state, "state ID PARENT", and each transition, "edge SOURCE TARGET : LABEL", and then
 * a line ====. If PlantUML refuses the diagram, its description is printed, "refused DESCRIPTION".
 */
public final class PlantUml {
    public static void main(String[] arguments) throws Exception {
        List<String> lines = new ArrayList<>();
        for (String text : Files.readString(Path.of(arguments[0])).split("====\n")) {
            for (BlockUml block : new SourceStringReader(text).getBlocks()) {
                Diagram diagram = block.getDiagram();
                if (diagram instanceof StateDiagram states) {
                    facts(states, lines);
                } else {
                    lines.add("refused " + diagram.getDescription());
                }
            }
            lines.add("====");
        }
        Files.write(Path.of(arguments[1]), lines);
    }

    private static void facts(StateDiagram diagram, List<String> lines) {
        for (Entity leaf : diagram.leafs()) {
            if (leaf.getLeafType() != LeafType.NOTE && !isCircle(leaf)) {
                lines.add("state " + leaf.getName() + " " + parent(leaf));
            }
        }
        for (Entity group : diagram.groups()) {
            if (group.getGroupType() != GroupType.CONCURRENT_STATE) {
                lines.add("state " + group.getName() + " " + parent(group));
            }
        }
        for (Link link : diagram.getLinks()) {
            String label = Display.isNull(link.getLabel())
                    ? ""
                    : " : " + String.join(" ", link.getLabel().asList().stream().map(Object::toString).toList());
            if (!isNote(link.getEntity1()) && !isNote(link.getEntity2()) && !link.isInvis()) {
                // A link up or to the left is kept the other way round.
                Entity from = link.isInverted() ? link.getEntity2() : link.getEntity1();
                Entity to = link.isInverted() ? link.getEntity1() : link.getEntity2();
                lines.add("edge " + end(from) + " " + end(to) + label);
            }
        }
    }

    private static boolean isNote(Entity entity) {
        return entity.getLeafType() == LeafType.NOTE;
    }

    private static boolean isCircle(Entity entity) {
        return end(entity).equals("[*]");
    }

    private static String end(Entity entity) {
        boolean circle = entity.getLeafType() == LeafType.CIRCLE_START || entity.getLeafType() == LeafType.CIRCLE_END;
        return circle ? "[*]" : entity.getName();
    }

    private static String parent(Entity entity) {
        Entity parent = entity.getParentContainer();
        while (parent != null && parent.getGroupType() == GroupType.CONCURRENT_STATE) {
            parent = parent.getParentContainer();
        }
        return parent == null || parent.isRoot() ? "-" : parent.getName();
    }
}

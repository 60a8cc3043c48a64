package org.evoloop.models;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.Architectures;

/** The packages of the tool and the dependencies between them. */
@AnalyzeClasses(packages = "org.evoloop.models", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule arrowsRunDown = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("commands")
            .definedBy("org.evoloop.models")
            .layer("studio")
            .definedBy("org.evoloop.models.studio..")
            .layer("scaffold")
            .definedBy("org.evoloop.models.scaffold..", "org.evoloop.models.device..")
            .layer("checking")
            .definedBy("org.evoloop.models.checking..")
            .layer("temporal")
            .definedBy("org.evoloop.models.temporal..")
            .layer("evolution")
            .definedBy("org.evoloop.models.evolution..")
            .layer("flat")
            .definedBy("org.evoloop.models.flat..")
            .layer("record")
            .definedBy("org.evoloop.models.record..")
            .layer("format")
            .definedBy("org.evoloop.models.format..")
            .layer("diagram")
            .definedBy("org.evoloop.models.diagram..")
            .layer("chart")
            .definedBy("org.evoloop.models.chart..")
            .whereLayer("commands")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("studio")
            .mayOnlyAccessLayers("checking", "temporal", "evolution", "diagram", "chart")
            .whereLayer("scaffold")
            .mayNotAccessAnyLayer()
            .whereLayer("checking")
            .mayOnlyAccessLayers("chart", "diagram", "format")
            .whereLayer("temporal")
            .mayNotAccessAnyLayer()
            .whereLayer("evolution")
            .mayOnlyAccessLayers("chart", "diagram", "format")
            .whereLayer("flat")
            .mayOnlyAccessLayers("chart")
            .whereLayer("record")
            .mayOnlyAccessLayers("chart", "diagram", "format")
            .whereLayer("format")
            .mayOnlyAccessLayers("chart")
            .whereLayer("diagram")
            .mayOnlyAccessLayers("chart")
            .whereLayer("chart")
            .mayNotAccessAnyLayer();

    @ArchTest
    static final ArchRule onlyTheScaffoldAndDeviceFilesUseFiles = noClasses()
            .that()
            .resideOutsideOfPackages(
                    "org.evoloop.models", "org.evoloop.models.scaffold..", "org.evoloop.models.device..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("java.nio.file..");

    @ArchTest
    static final ArchRule elkIsKnownInOneRoom = noClasses()
            .that()
            .resideOutsideOfPackage("org.evoloop.models.diagram..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.eclipse..");
}

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Rig</name>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translation>
        <numerusform>ready (%n day old)</numerusform>
        <numerusform>ready (%n days old)</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translation>
        <numerusform>%n sherd, all sure</numerusform>
        <numerusform>%n sherds, all sure</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1 is ready: %n sherd(s).</source>
      <translation>
        <numerusform>%1 is ready: %n sherd.</numerusform>
        <numerusform>%1 is ready: %n sherds.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) queued.</source>
      <translation>
        <numerusform>Paused; %n batch queued.</numerusform>
        <numerusform>Paused; %n batches queued.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translation>
        <numerusform>%n sherd</numerusform>
        <numerusform>%n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translation>
        <numerusform>%1; but %n counted on the plate</numerusform>
        <numerusform>%1; but %n counted on the plate</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1; %n photographed again since</source>
      <translation>
        <numerusform>%1; %n photographed again since</numerusform>
        <numerusform>%1; %n photographed again since</numerusform>
      </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n to reshoot</source>
        <translation>
            <numerusform>%1; %n to reshoot</numerusform>
            <numerusform>%1; %n to reshoot</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BulkEdit</name>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translation>
        <numerusform>%n sherd chosen</numerusform>
        <numerusform>%n sherds chosen</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translation>
        <numerusform>Change %n sherd</numerusform>
        <numerusform>Change %n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) ask for a confirmation.</source>
        <translation>
            <numerusform>%n value asks for a confirmation.</numerusform>
            <numerusform>%n values ask for a confirmation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureScreen</name>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translation>
        <numerusform>%1: %n file imported; it is in the queue.</numerusform>
        <numerusform>%1: %n files imported; it is in the queue.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureWizard</name>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are saved.</source>
      <translation>
        <numerusform>The %n photograph of this side so far is saved.</numerusform>
        <numerusform>The %n photographs of this side so far are saved.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translation>
        <numerusform>Front: %n sherd</numerusform>
        <numerusform>Front: %n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) saved</source>
      <translation>
        <numerusform>%n photograph saved</numerusform>
        <numerusform>%n photographs saved</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translation>
        <numerusform>%n sherd seen</numerusform>
        <numerusform>%n sherds seen</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translation>
        <numerusform>Room for about %n more</numerusform>
        <numerusform>Room for about %n more</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueScreen</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translation>
        <numerusform>change %1 of %n sherd</numerusform>
        <numerusform>change %1 of %n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Export %n sherd(s)</source>
      <translation>
        <numerusform>Export %n sherd</numerusform>
        <numerusform>Export %n sherds</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::DrawingPage</name>
    <message numerus="yes">
      <source>Drawing %n sherd(s)…</source>
      <translation>
        <numerusform>Drawing %n sherd…</numerusform>
        <numerusform>Drawing %n sherds…</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translation>
        <numerusform>Draw plates of %n sherd</numerusform>
        <numerusform>Draw plates of %n sherds</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportModel</name>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translation>
        <numerusform>about %n minute</numerusform>
        <numerusform>about %n minutes</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translation>
        <numerusform>%n sherd, %1 files, %2, %3</numerusform>
        <numerusform>%n sherds, %1 files, %2, %3</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translation>
        <numerusform>%n sherd, %1, manifest checked</numerusform>
        <numerusform>%n sherds, %1, manifest checked</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model: %1</source>
      <translation>
        <numerusform>%n of them without a model: %1</numerusform>
        <numerusform>%n of them without a model: %1</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n file(s) of the project are missing, changed or links; damage.txt in the archive lists them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n file of the project is missing, changed or a link; damage.txt in the archive lists it.</numerusform>
        <numerusform>%n files of the project are missing, changed or links; damage.txt in the archive lists them.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
        <source>%n batch(es) in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</source>
        <translation>
            <numerusform>%n batch in the queue: the archive holds its photographs and the stages that are finished when it is made; the restored project processes the rest.</numerusform>
            <numerusform>%n batches in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportScreen</name>
    <message numerus="yes">
      <source>%n selected sherd(s)</source>
      <translation>
        <numerusform>%n selected sherd</numerusform>
        <numerusform>%n selected sherds</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::FilterLine</name>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translation>
        <numerusform>%n sherd</numerusform>
        <numerusform>%n sherds</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::HeaderLine</name>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translation>
        <numerusform>Disk: room for %n batch</numerusform>
        <numerusform>Disk: room for %n batches</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportDialog</name>
    <message numerus="yes">
      <source>Import %n row(s)</source>
      <translation>
        <numerusform>Import %n row</numerusform>
        <numerusform>Import %n rows</numerusform>
      </translation>
    </message>
    <message numerus="yes">
        <source>Columns (%n to check)</source>
        <translation>
            <numerusform>Columns (%n to check)</numerusform>
            <numerusform>Columns (%n to check)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Confirm %n row(s)</source>
        <translation>
            <numerusform>Confirm %n row</numerusform>
            <numerusform>Confirm %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportModel</name>
    <message numerus="yes">
      <source>Cancelled: %n row(s) were not imported. Import the table again for the rest.</source>
      <translation>
        <numerusform>Cancelled: %n row was not imported. Import the table again for the rest.</numerusform>
        <numerusform>Cancelled: %n rows were not imported. Import the table again for the rest.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) ask for a confirmation.</source>
        <translation>
            <numerusform>%n row asks for a confirmation.</numerusform>
            <numerusform>%n rows ask for a confirmation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapScreen</name>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translation>
        <numerusform>%n label are sent to the printer.</numerusform>
        <numerusform>%n labels are sent to the printer.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translation>
        <numerusform>%n sherd of this batch has no number yet: its label names the batch.</numerusform>
        <numerusform>%n sherds of this batch have no number yet: their labels name the batch.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateView</name>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translation>
        <numerusform>%n sherd seen</numerusform>
        <numerusform>%n sherds seen</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::QueueScreen</name>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translation>
        <numerusform>%n batch stopped and needs you</numerusform>
        <numerusform>%n batches stopped and need you</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewScreen</name>
    <message numerus="yes">
      <source>%n pair(s) to review</source>
      <translation>
        <numerusform>%n pair to review</numerusform>
        <numerusform>%n pairs to review</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdEdits</name>
    <message numerus="yes">
      <source>numbering of %n sherd(s)</source>
      <translation>
        <numerusform>numbering of %n sherd</numerusform>
        <numerusform>numbering of %n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) got no number: %1</source>
      <translation>
        <numerusform>%n sherd got no number: %1</numerusform>
        <numerusform>%n sherds got no number: %1</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberingEdit</name>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translation>
        <numerusform>and in %n more context</numerusform>
        <numerusform>and in %n more contexts</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui</name>
    <message numerus="yes">
      <source>%1 of %n sherd(s)</source>
      <translation>
        <numerusform>%1 of %n sherd</numerusform>
        <numerusform>%1 of %n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translation>
        <numerusform>%n sherd</numerusform>
        <numerusform>%n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep a number of the old context: %1.</source>
      <translation>
        <numerusform>%n sherd keeps a number of the old context: %1.</numerusform>
        <numerusform>%n sherds keep a number of the old context: %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag, because there is no bag %1 yet.</source>
      <translation>
        <numerusform>%n sherd leaves its bag, because there is no bag %1 yet.</numerusform>
        <numerusform>%n sherds leave their bag, because there is no bag %1 yet.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag.</source>
      <translation>
        <numerusform>%n sherd leaves its bag.</numerusform>
        <numerusform>%n sherds leave their bag.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectCare</name>
    <message numerus="yes">
      <source>%n file(s) of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</source>
      <translation>
        <numerusform>%n file of this project is missing or was changed: %1. Put it back from a copy; &apos;ostraka catalogue check&apos; lists it.</numerusform>
        <numerusform>%n files of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>PlaceText</name>
    <message numerus="yes">
        <source>%n sherd(s) counted</source>
        <translation>
            <numerusform>%n sherd counted</numerusform>
            <numerusform>%n sherds counted</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskPage</name>
    <message numerus="yes">
        <source>%n photograph(s) edited. Reprocess to update what follows from them.</source>
        <translation>
            <numerusform>%n photograph edited. Reprocess to update what follows from it.</numerusform>
            <numerusform>%n photographs edited. Reprocess to update what follows from them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SidesView</name>
    <message numerus="yes">
      <source>%1: %n photograph(s), %2 to %3</source>
      <translation>
        <numerusform>%1: %n photograph, %2 to %3</numerusform>
        <numerusform>%1: %n photographs, %2 to %3</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeDialog</name>
    <message numerus="yes">
      <source>%n conflict(s) to settle</source>
      <translation>
        <numerusform>%n conflict to settle</numerusform>
        <numerusform>%n conflicts to settle</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeModel</name>
    <message numerus="yes">
      <source>Missing in the other project: %n file(s), %1</source>
      <translation>
        <numerusform>Missing in the other project: %n file, %1</numerusform>
        <numerusform>Missing in the other project: %n files, %1</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BatchImporter</name>
    <message numerus="yes">
      <source>Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</source>
      <translation>
        <numerusform>Sheet recognised: %n marker. Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</numerusform>
        <numerusform>Sheet recognised: %n markers. Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CompareWindow</name>
    <message numerus="yes">
      <source>%n field(s) differ.</source>
      <translation>
            <numerusform>%n field differs.</numerusform>
            <numerusform>%n fields differ.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::StartScreen</name>
    <message numerus="yes">
      <source>%1; %n batch(es) unfinished</source>
      <translation>
        <numerusform>%1; %n batch unfinished</numerusform>
        <numerusform>%1; %n batches unfinished</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlacesDialog</name>
    <message numerus="yes">
      <source>%n context(s)</source>
      <translation>
        <numerusform>%n context</numerusform>
        <numerusform>%n contexts</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n bag(s)</source>
      <translation>
        <numerusform>%n bag</numerusform>
        <numerusform>%n bags</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es)</source>
      <translation>
        <numerusform>%n batch</numerusform>
        <numerusform>%n batches</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translation>
        <numerusform>%n sherd</numerusform>
        <numerusform>%n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep the number that is written on them; new numbers go on behind these.</source>
      <translation>
        <numerusform>%n sherd keeps the number that is written on it; new numbers go on behind it.</numerusform>
        <numerusform>%n sherds keep the numbers that are written on them; new numbers go on behind these.</numerusform>
      </translation>
    </message>
</context>
</TS>
